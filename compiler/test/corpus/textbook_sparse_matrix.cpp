// Sparse matrix times vector, compressed rows: loop bounds from memory.
// top: textbook_sparse_matrix
// range: row_start=0..8
// range: columns=0..3
void textbook_sparse_matrix(const unsigned char row_start[5], const unsigned char columns[8], const int values[8],
                            const int x[4], int y[4]) {
  for (int r = 0; r < 4; ++r) {
    int sum = 0;
    for (int k = row_start[r]; k < row_start[r + 1]; ++k) sum += values[k] * x[columns[k]];
    y[r] = sum;
  }
}
