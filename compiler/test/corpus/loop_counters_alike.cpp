// Two pipelined loops with a counter each that steps alike, in a loop around them; the first one's end is used behind both.
// top: loop_counters_alike
// range: n=0..30
int loop_counters_alike(const int a[32], unsigned char n) {
  int sum = 0;
  for (int pass = 0; pass < 3; ++pass) {
    unsigned char end = 0;
    for (unsigned char i = 0; i < 32; ++i) {
#pragma HLS PIPELINE II=1
      sum += a[i] * (i + pass);
      end = i;
      if (i == n) break;
    }
    int product = 1;
    for (unsigned char i = 0; i < 32; ++i) {
#pragma HLS PIPELINE II=1
      product = product * 3 + a[i];
    }
    sum += end + product;
  }
  return sum;
}
