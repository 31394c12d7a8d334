// ARRAY_PARTITION of a scalar.
// top: pragma_partition_scalar
int pragma_partition_scalar(int a) {
  int b = a * 3;
#pragma HLS ARRAY_PARTITION variable=b complete
  return b + 1;
}
// warning: 5:9: pragma 'ARRAY_PARTITION' has no effect: 'b' is no array
