// Two reads of one memory cannot have II = 1.
// top: unmet_loop
int unmet_loop(const int a[16]) {
  int sum = 0;
  for (int i = 1; i < 16; ++i) sum += a[i] * a[i - 1];  // expect: loop II=1
  return sum;
}
