// The constructors of a global object and of a static local run before the first call.
// top: state_global_object
class Leaky {
 public:
  Leaky(int start, int shift) : state_(start * 3), shift_(shift) {}
  int step(int x) {
    state_ += x - (state_ >> shift_);
    return state_;
  }

 private:
  int state_;
  const int shift_;
};
static Leaky first(100, 2);
int state_global_object(int x) {
  static Leaky second(-7, 3);
  return second.step(first.step(x & 1023));
}
