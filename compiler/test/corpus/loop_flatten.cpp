// Perfect nests become one loop: three loops by themselves under PIPELINE, bounds known at run time, and statements
// around the inner loop where LOOP_FLATTEN asks for it. One that another row depends on keeps its inner II.
// top: loop_flatten
// range: rows=0..6
// range: columns=0..6
int loop_flatten(const int a[4][6], int b[4][6], int state[8], int rows, int columns) {
  int sum = 0;
  for (int k = 0; k < 3; ++k)
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 6; ++x) {  // expect: loop II=1 cycles=73
#pragma HLS PIPELINE II = 1
        sum += a[y][x] ^ (k + y);
      }
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {  // expect: loop II=1
#pragma HLS PIPELINE II = 1
      sum = sum * 3 + y * x;
      if (sum == 77) break;
    }
  for (int y = 0; y < 4; ++y) {
    int row = y;
    for (int x = 0; x < 6; ++x) {  // expect: loop II=1
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_FLATTEN
      row += a[y][x];
      b[y][x] = row - x;
    }
    sum += row;
  }
  for (int y = 0; y < 3; ++y)  // expect: loop sequential
    for (int x = 0; x < 8; ++x) {  // expect: loop II=1
#pragma HLS PIPELINE II = 1
      state[x] = state[x] * 5 + y;
    }
  return sum;
}
