// The inner bound depends on the outer index.
// top: loop_triangular
int loop_triangular(const int a[8]) {
  int inversions = 0;
  for (int i = 0; i < 8; ++i)
    for (int j = i + 1; j < 8; ++j) inversions += a[i] > a[j];
  return inversions;
}
