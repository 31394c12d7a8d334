void interface_m_axi(const int a[16], int b[16]) {
#pragma HLS INTERFACE m_axi port=a offset=slave bundle=gmem
  for (int i = 0; i < 16; ++i) b[i] = a[i];
}
// error: 2:9: INTERFACE mode 'm_axi' is not built; use hls::stream with axis, or an array with ap_memory
