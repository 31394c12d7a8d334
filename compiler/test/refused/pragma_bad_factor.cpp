int pragma_bad_factor(int x) {
  int a[8];
#pragma HLS ARRAY_PARTITION variable=a cyclic factor=0
  for (int i = 0; i < 8; ++i) a[i] = i * x;
  return a[x & 7];
}
// error: 3:9: factor of pragma 'ARRAY_PARTITION' must be at least 1
