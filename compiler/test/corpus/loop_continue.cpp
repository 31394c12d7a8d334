// continue skips the rest of an iteration.
// top: loop_continue
int loop_continue(const int a[32]) {
  int sum = 0;
  for (int i = 0; i < 32; ++i) {  // expect: loop II=1
    if (a[i] & 1) continue;
    sum += a[i] >> 3;
  }
  return sum;
}
