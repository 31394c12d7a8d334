// Two writes an iteration of an array outside, and four reads in two cycles of one that another loop writes.
// top: array_two_ports_write
void array_two_ports_write(const short in[32], short twice[64], short work[64], int sums[16]) {
  for (int i = 0; i < 32; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    twice[2 * i] = in[i];
    twice[2 * i + 1] = -in[i];
    work[i] = in[i] * 3;
  }
  for (int i = 0; i < 16; ++i) {  // expect: loop II=2
#pragma HLS PIPELINE II=2
    sums[i] = work[i] + work[i + 16] * 2 + work[31 - i] * 3 + work[i + 32];
  }
}
