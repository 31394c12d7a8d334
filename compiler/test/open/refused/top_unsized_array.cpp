int top_unsized_array(const int* data, int n) {
  int sum = 0;
  for (int i = 0; i < n; ++i) sum += data[i];
  return sum;
}
