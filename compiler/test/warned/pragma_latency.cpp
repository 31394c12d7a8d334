// LATENCY that the schedule does not keep, and where nothing checks it.
// top: pragma_latency
static int inlined(int x) {
#pragma HLS LATENCY max = 1
  return x * x;
}
int pragma_latency(const int a[16]) {
#pragma HLS LATENCY max = 3
  int sum = 0;
  for (int i = 0; i < 16; ++i) {
#pragma HLS LATENCY min = 2
    sum += inlined(a[i]);
  }
  return sum;
}
// warning: 11:9: pragma 'LATENCY' has no effect here; results are the same without it
// warning: 3: pragma 'LATENCY' has no effect in a function that is inlined
// warning: 7:5: LATENCY of 'pragma_latency' does not hold: it takes 21 cycles
