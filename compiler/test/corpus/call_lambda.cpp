// A lambda that inlines.
// top: call_lambda
int call_lambda(int a, int b) {
  auto scale = [b](int v) { return v * 3 + b; };
  return scale(a) - scale(b);
}
