// Overloaded operators on a struct.
// top: call_operator_overload
struct Complex {
  int re, im;
};
inline Complex operator*(Complex a, Complex b) {
  Complex r = {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  return r;
}
void call_operator_overload(int ar, int ai, int br, int bi, int& re, int& im) {
  Complex a = {ar, ai}, b = {br, bi};
  Complex c = a * b * a;
  re = c.re;
  im = c.im;
}
