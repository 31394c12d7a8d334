#include <string>
int standard_string(int n) {
  std::string s = "floor";
  s += static_cast<char>(n);
  return static_cast<int>(s.size());
}
