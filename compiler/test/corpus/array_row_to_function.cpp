// A row of a matrix passed to a function.
// top: array_row_to_function
static int sum_of(const int row[8]) {
  int sum = 0;
  for (int i = 0; i < 8; ++i) sum += row[i];
  return sum;
}
void array_row_to_function(const int matrix[4][8], int sums[4]) {
  for (int r = 0; r < 4; ++r) sums[r] = sum_of(matrix[r]);  // expect: loop sequential
}
