// A pipelined loop calls a function with loops: they dissolve as the loop's own would.
// top: loop_pipeline_inlined_loops
static int weigh(const short window[3][3]) {
#pragma HLS INLINE
  const signed char weights[3][3] = {{-1, 0, 1}, {-2, 0, 2}, {-1, 0, 1}};
  int sum = 0;
  for (char i = 0; i < 3; i++)
    for (char j = 0; j < 3; j++) sum += window[i][j] * weights[i][j];
  return sum;
}
void loop_pipeline_inlined_loops(const short in[32], int out[32]) {
  short window[3][3] = {};
  for (int c = 0; c < 32; c++) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    for (int i = 0; i < 3; i++) {
      window[i][0] = window[i][1];
      window[i][1] = window[i][2];
    }
    window[0][2] = window[1][1];
    window[1][2] = window[2][1];
    window[2][2] = in[c];
    out[c] = weigh(window);
  }
}
