// Prefix sum with a carried register.
// top: textbook_prefix_sum
void textbook_prefix_sum(const int in[32], int out[32]) {
  int sum = 0;
  for (int i = 0; i < 32; ++i) {  // expect: loop II=1 depth=2
#pragma HLS PIPELINE II=1
    sum += in[i];
    out[i] = sum;
  }
}
