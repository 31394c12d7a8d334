// std::array with a range-based loop behind a template and a lambda; enum class selects.
// top: language_std_array
#include <array>
#include <cstdint>
enum class Mode : std::uint8_t { sum, product };
template <class Function>
static int fold(const std::array<int, 8>& values, int start, Function join) {
  for (int value : values) start = join(start, value);
  return start;
}
int language_std_array(const int data[8], bool multiplies) {
  std::array<int, 8> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = data[i];
  switch (multiplies ? Mode::product : Mode::sum) {
    case Mode::product: return fold(values, 1, [](int a, int b) { return a * b; });
    default: return fold(values, 0, [](int a, int b) { return a + b; });
  }
}
