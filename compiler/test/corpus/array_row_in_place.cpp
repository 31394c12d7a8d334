// Rows and columns that are read and written in place: the words of different iterations are different.
// top: array_row_in_place
void array_row_in_place(const int in[6][8], int out[6][8], int k) {
  int t[6][8];
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 8; ++c) t[r][c] = in[r][c];
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 8; ++c) t[r][c] = t[r][c] * k + c;  // expect: loop II=1
  for (int c = 0; c < 8; ++c)
    for (int r = 1; r < 6; ++r) t[r][c] = t[r - 1][c] * k + r;
  for (int c = 0; c < 7; ++c)
    for (int r = 0; r < 6; ++r) t[r][c] = t[r][c + 1] * k + r;  // expect: loop II=1
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 8; ++c) out[r][c] = t[r][c];
}
