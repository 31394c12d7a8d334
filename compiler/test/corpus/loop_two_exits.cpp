// A loop with a bound and a break on data, then code on how it ended.
// top: loop_two_exits
int loop_two_exits(const int a[16], int limit) {
  int sum = 0, i = 0;
  for (i = 0; i < 16; ++i) {
    sum += a[i] & 255;
    if (sum > (limit & 1023)) break;
  }
  return i == 16 ? -sum : sum * 100 + i;
}
