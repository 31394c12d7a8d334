// An II that cannot be reached, with its cause.
// top: pipeline_ii_missed
int pipeline_ii_missed(const int a[16]) {
  int sum = 0;
  for (int i = 0; i < 15; ++i) {
#pragma HLS PIPELINE II=1
    sum += a[i] * a[15 - i];
  }
  return sum;
}
// warning: 5:3: II = 1 is not reached, II is 2: the read port of 'a' is used at pipeline_ii_missed.cpp:7:12, pipeline_ii_missed.cpp:7:19; partition the array or access it once an iteration
