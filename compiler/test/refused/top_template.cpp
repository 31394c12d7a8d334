template <int N>
int top_template(int x) {
  return x * N;
}
