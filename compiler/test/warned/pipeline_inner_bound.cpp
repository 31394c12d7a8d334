// A loop in a pipelined loop whose trip count is not known.
// top: pipeline_inner_bound
int pipeline_inner_bound(const int a[64], int n) {
  int sum = 0;
  for (int i = 0; i < 8; ++i) {
#pragma HLS PIPELINE
    for (int j = 0; j < (n & 7); ++j) sum += a[8 * i + j];
  }
  return sum;
}
// warning: 7:5: this loop in a pipeline is not unrolled because its trip count is not known; it is pipelined itself
