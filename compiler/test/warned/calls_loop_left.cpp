// PIPELINE of a function in which a loop is left: that loop is pipelined, and calls follow each other.
// top: calls_loop_left
int calls_loop_left(const int a[64], int n) {
#pragma HLS PIPELINE II=4
  int sum = 0;
  for (int i = 0; i < (n & 63); ++i) sum += a[i];
  return sum;
}
// warning: 6:3: this loop in a pipeline is not unrolled because its trip count is not known; it is pipelined itself
// warning: 3:5: calls of 'calls_loop_left' do not overlap as PIPELINE asks: the loop at calls_loop_left.cpp:6:3 is left in it
