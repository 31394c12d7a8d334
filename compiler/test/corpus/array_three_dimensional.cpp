// A three-dimensional array, in and out.
// top: array_three_dimensional
void array_three_dimensional(const short in[3][4][5], short out[5][4][3]) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 5; ++k) out[k][j][i] = in[i][j][k] + i * j;  // expect: loop II=1
}
