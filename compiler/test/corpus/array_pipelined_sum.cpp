// A pipelined reduction over a memory.
// top: array_pipelined_sum
int array_pipelined_sum(const short a[64]) {
  int sum = 0;
SUM:
  for (int i = 0; i < 64; ++i) {  // expect: loop II=1 depth=2 cycles=65
#pragma HLS PIPELINE II=1
    sum += a[i];
  }
  return sum;
}
