// A conditional store to memory.
// top: array_byte_enable_free
void array_byte_enable_free(const int in[24], int out[24], int threshold) {
  for (int i = 0; i < 24; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    out[i] = 0;
    if (in[i] > threshold) out[i] = in[i];
  }
}
