template <int N>
int top_template(int x) {
  return x * N;
}
// error: no function 'top_template' is defined in the sources; give its name with --top
