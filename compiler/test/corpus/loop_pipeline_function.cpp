// PIPELINE in a function unrolls the loops inside it.
// top: loop_pipeline_function
// expect: latency 1
int loop_pipeline_function(int a, int b) {
#pragma HLS PIPELINE II=1
  int x = a;
  for (int i = 0; i < 4; ++i) x = (x << 1) ^ (b >> i);
  return x;
}
