int float_inside(int x) {
  float y = x;
  return static_cast<int>(y * 0.3f);
}
