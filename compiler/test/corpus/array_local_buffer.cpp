// A local array filled, then read in another order.
// top: array_local_buffer
// expect: memory buffer ram 32x8 count=1
void array_local_buffer(const unsigned char in[32], unsigned char out[32]) {
  unsigned char buffer[32];
LOAD:
  for (int i = 0; i < 32; ++i) {  // expect: loop II=1 depth=2
#pragma HLS PIPELINE II=1
    buffer[i] = in[i];
  }
STORE:
  for (int i = 0; i < 32; ++i) {
#pragma HLS PIPELINE II=1
    out[i] = buffer[(i * 5) & 31];
  }
}
