// A run-time bound, zero included.
// top: loop_runtime_bound
// range: n=0..20
int loop_runtime_bound(unsigned char n) {
  int sum = 0;
  for (int i = 0; i < n; ++i) {
#pragma HLS PIPELINE II=1
    sum += i * i;
  }
  return sum;
}
