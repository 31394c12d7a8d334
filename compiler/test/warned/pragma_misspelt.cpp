// A misspelt pragma is named.
// top: pragma_misspelt
int pragma_misspelt(int a) {
  int sum = 0;
  for (int i = 0; i < 8; ++i) {
#pragma HLS PIPLINE II=1
    sum += a * i;
  }
  return sum;
}
// warning: 6:9: pragma 'PIPLINE' is not known and has no effect
