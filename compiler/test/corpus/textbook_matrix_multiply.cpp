// Matrix product.
// top: textbook_matrix_multiply
// expect: operators multiply=1
void textbook_matrix_multiply(const short a[5][6], const short b[6][4], int c[5][4]) {
ROW:
  for (int i = 0; i < 5; ++i) {
  COLUMN:
    for (int j = 0; j < 4; ++j) {
      int sum = 0;
    PRODUCT:
      for (int k = 0; k < 6; ++k) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
        sum += a[i][k] * b[k][j];
      }
      c[i][j] = sum;
    }
  }
}
