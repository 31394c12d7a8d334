// Addresses of rows in a flattened nest: a matrix product whose arrays are arguments.
// top: loop_flatten_rows
void loop_flatten_rows(const short a[3][3], const short b[3][3], int out[3][3]) {
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
#pragma HLS PIPELINE
      int sum = 0;
      for (int k = 0; k < 3; k++) sum += a[i][k] * b[k][j];
      out[i][j] = sum;
    }
}
