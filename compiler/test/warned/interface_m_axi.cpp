// A pointer that asks for a bus master has the ports of a memory.
// top: interface_m_axi
void interface_m_axi(const int* a, int* b, int n) {
#pragma HLS INTERFACE m_axi port=a offset=slave bundle=gmem depth=16
#pragma HLS INTERFACE m_axi port=b offset=slave bundle=gmem depth=16
#pragma HLS INTERFACE s_axilite port=a bundle=control
#pragma HLS INTERFACE s_axilite port=n bundle=control
#pragma HLS INTERFACE s_axilite port=return bundle=control
  for (int i = 0; i < n; ++i) b[i] = a[i];
}
// warning: 4:9: INTERFACE mode 'm_axi' is not built: 'a' has the ports of ap_memory in place of a bus master
// warning: 5:9: INTERFACE mode 'm_axi' is not built: 'b' has the ports of ap_memory in place of a bus master
