#include <cstdio>

void two_ports(int a[64], const int gains[64], int sums[32]);

int main() {
  int a[64], gains[64], sums[32];
  for (int i = 0; i < 64; ++i) {
    a[i] = i * i;
    gains[i] = 3 - i;
  }
  for (int call = 0; call < 2; ++call) {
    int before[64];
    for (int i = 0; i < 64; ++i) before[i] = a[i];
    two_ports(a, gains, sums);
    for (int i = 0; i < 32; ++i) {
      bool is_right =
          sums[i] == before[2 * i] + before[2 * i + 1] * gains[i] && a[2 * i] == i && a[2 * i + 1] == -i;
      if (!is_right) {
        std::printf("wrong at %d: %d, %d, %d\n", i, sums[i], a[2 * i], a[2 * i + 1]);
        return 1;
      }
    }
  }
  return 0;
}
