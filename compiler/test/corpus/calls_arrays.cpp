// Calls that overlap on arrays outside.
// top: calls_arrays
// calls: 20
int calls_arrays(const int a[16], int b[16], unsigned n) {  // expect: loop II=4
#pragma HLS PIPELINE II=4
  int sum = 0;
  for (int i = 0; i < 4; ++i) {
    sum += a[(n + i) & 15];
    b[(n + 3 * i) & 15] = sum;
  }
  return sum * n;
}
