// II=2 asked for and reached.
// top: loop_pipeline_ii2
int loop_pipeline_ii2(const int a[20]) {
  int sum = 0;
  for (int i = 0; i < 20; ++i) {  // expect: loop II=2 depth=2 cycles=40
#pragma HLS PIPELINE II=2
    sum += a[i] - (sum >> 2);
  }
  return sum;
}
