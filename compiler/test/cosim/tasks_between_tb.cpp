void tasks_between(const int in[32], int out[32], int count);

int main() {
  for (int round = 0; round < 3; ++round) {
    const int count = 20 + 5 * round;
    int in[32], out[32] = {};
    for (int i = 0; i < 32; ++i) in[i] = i * i + round;
    tasks_between(in, out, count);
    for (int i = 0; i < 32; ++i)
      if (out[i] != (i < count ? 3 * in[i] + 1 : 0)) return 1;
  }
  return 0;
}
