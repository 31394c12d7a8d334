// A top in a namespace, with an enum class and a nested struct.
// top: language_namespace_top
namespace filters {
enum class Mode { kAdd, kSubtract, kSwap };
struct Range {
  int low, high;
};
int clamp(int value, const Range& range) { return value < range.low ? range.low : value > range.high ? range.high : value; }
int language_namespace_top(int a, int b, unsigned char select) {
  Mode mode = static_cast<Mode>(select % 3);
  Range range = {-1000, 1000};
  switch (mode) {
    case Mode::kAdd:
      return clamp(a + b, range);
    case Mode::kSubtract:
      return clamp(a - b, range);
    default:
      return b;
  }
}
}  // namespace filters
