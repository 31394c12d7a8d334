// A class with members and methods.
// top: call_class_member
class Accumulator {
 public:
  Accumulator() : sum_(0), count_(0) {}
  void add(int v) {
    sum_ += v;
    ++count_;
  }
  int scaled() const { return sum_ * count_; }

 private:
  int sum_, count_;
};
int call_class_member(const int a[8]) {
  Accumulator accumulator;
  for (int i = 0; i < 8; ++i) accumulator.add(a[i]);
  return accumulator.scaled();
}
