int top_unsized_array(const int* data, int n) {
  int sum = 0;
  for (int i = 0; i < n; ++i) sum += data[i];
  return sum;
}
// error: 1:5: the size of 'data' is not known; declare it as an array, data[64], or give INTERFACE port=data a depth
