#include <vector>
int standard_container(int n) {
  std::vector<int> v(4, n);
  v.push_back(n);
  return v[n & 3];
}
