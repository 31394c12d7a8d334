// Function templates with type and value parameters.
// top: call_template
template <int N, typename T>
T horner(const T c[N], T x) {
  T r = 0;
  for (int i = 0; i < N; ++i) r = r * x + c[i];
  return r;
}
int call_template(const int c[5], int x) { return horner<5, int>(c, x) + horner<3, int>(c, x); }
