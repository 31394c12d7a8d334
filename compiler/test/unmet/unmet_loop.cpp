// Three reads of one memory with two ports cannot have II = 1.
// top: unmet_loop
int unmet_loop(const int a[16]) {
  int sum = 0;
  for (int i = 2; i < 16; ++i) sum += a[i] * a[i - 1] * a[i - 2];  // expect: loop II=1
  return sum;
}
