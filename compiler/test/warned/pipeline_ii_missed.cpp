// An II that cannot be reached, with its cause: three reads an iteration of an array outside, which has two ports.
// top: pipeline_ii_missed
int pipeline_ii_missed(const int a[16]) {
  int sum = 0;
  for (int i = 0; i < 15; ++i) {
#pragma HLS PIPELINE II=1
    sum += a[i] * a[15 - i] + a[i ^ 5];
  }
  return sum;
}
// warning: 5:3: II = 1 is not reached, II is 2: the pair of ports of 'a' is used at pipeline_ii_missed.cpp:7:12, pipeline_ii_missed.cpp:7:19, pipeline_ii_missed.cpp:7:31; partition the array or access it once an iteration
