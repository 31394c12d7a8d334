int float_inside(int x) {
  float y = x;
  return static_cast<int>(y * 0.3f);
}
// error: 2:13: floating point has no operators yet; use ap_fixed
