// It is the pair of ports that limits this loop.
// top: unmet_reason
int unmet_reason(const int a[16]) {
  int sum = 0;
  for (int i = 2; i < 16; ++i) sum += a[i] * a[i - 1] * a[i - 2];  // expect: loop II=2 because the write port
  return sum;
}
