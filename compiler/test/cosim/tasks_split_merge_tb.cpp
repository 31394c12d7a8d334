#include <algorithm>

void tasks_split_merge(const int in[32], int ordered[32], const int more[32], int any_order[32]);

int main() {
  int in[32], more[32], ordered[32], any_order[32];
  for (int i = 0; i < 32; ++i) in[i] = i * i, more[i] = 7 * i;
  tasks_split_merge(in, ordered, more, any_order);
  std::sort(any_order, any_order + 32);
  for (int i = 0; i < 32; ++i)
    if (ordered[i] != 2 * in[i] + 5 || any_order[i] != 2 * more[i] + 5) return 1;
  return 0;
}
