#include <atomic>
int atomic_use(int x) {
  static std::atomic<int> count{0};
  return count.fetch_add(x);
}
// error: 2:5: a value of 'atomic_use' has no hardware form; use integers, ap types and subscripts
