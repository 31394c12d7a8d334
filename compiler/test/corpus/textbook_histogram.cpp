// Histogram of an array into an array.
// top: textbook_histogram
void textbook_histogram(const unsigned char in[128], int out[32]) {
  for (int i = 0; i < 32; ++i) out[i] = 0;
  for (int i = 0; i < 128; ++i) out[in[i] & 31] += 1;  // expect: loop II=2 because 'out
}
