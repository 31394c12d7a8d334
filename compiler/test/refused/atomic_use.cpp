#include <atomic>
int atomic_use(int x) {
  static std::atomic<int> count{0};
  return count.fetch_add(x);
}
