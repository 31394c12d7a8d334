// Sixteen words take sixteen cycles at least.
// top: unmet_latency
// expect: latency 3
int unmet_latency(const int a[16]) {
  int sum = 0;
  for (int i = 0; i < 16; ++i) sum += a[i];
  return sum;
}
