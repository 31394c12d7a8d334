#include <vector>
int standard_container(int n) {
  std::vector<int> v(4, n);
  v.push_back(n);
  return v[n & 3];
}
// error: 3:20: 'std::vector<int>' needs a heap, which hardware lacks; use an array of fixed size
