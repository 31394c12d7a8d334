int pragma_partition_unknown_variable(int x) {
  int a[4] = {x, 1, 2, 3};
#pragma HLS ARRAY_PARTITION variable=b complete
  return a[x & 3];
}
// error: 3:38: use of undeclared identifier 'b'
