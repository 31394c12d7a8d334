// A local array in registers, read in parallel.
// top: array_partition_complete
// expect: memory copy registers 8x32
int array_partition_complete(const int in[8]) {
  int copy[8];
#pragma HLS ARRAY_PARTITION variable=copy complete
  for (int i = 0; i < 8; ++i) {
#pragma HLS PIPELINE II=1
    copy[i] = in[i];
  }
  int sum = 0;
  for (int i = 0; i < 8; ++i) {
#pragma HLS UNROLL
    sum += copy[i] * (i + 1);
  }
  return sum;
}
