struct Shape {
  virtual int area(int x) { return x; }
};
struct Square : Shape {
  int area(int x) override { return x * x; }
};
int virtual_call(int x, bool square) {
  Shape shape;
  Square other;
  Shape* chosen = square ? &other : &shape;
  return chosen->area(x);
}
// error: 2:15: virtual functions have no hardware form; use a template parameter or a plain member function
