// A perfect nest with a pipelined inner loop.
// top: loop_nested_flatten
int loop_nested_flatten(int a) {
  int x = a;
ROW:
  for (int r = 0; r < 7; ++r) {
  COLUMN:
    for (int c = 0; c < 5; ++c) {  // expect: loop II=1 cycles=35
#pragma HLS LOOP_FLATTEN
#pragma HLS PIPELINE II=1
      x = x + (r ^ c);
    }
  }
  return x;
}
