// Inheritance and CRTP without virtual functions.
// top: language_inheritance
template <class Derived>
struct Filter {
  int run(int x) { return static_cast<Derived*>(this)->step(x) + 1; }
};
struct Average : Filter<Average> {
  int last;
  Average() : last(0) {}
  int step(int x) {
    int mean = (x >> 1) + (last >> 1);
    last = x;
    return mean;
  }
};
int language_inheritance(int a, int b) {
  static Average average;
  return average.run(a) ^ average.run(b);
}
