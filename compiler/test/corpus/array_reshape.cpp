// Reshaped array: wide words.
// top: array_reshape
// expect: memory words ram 16x8
int array_reshape(const unsigned char in[16]) {
  unsigned char words[16];
#pragma HLS ARRAY_RESHAPE variable=words cyclic factor=4
  for (int i = 0; i < 16; ++i) words[i] = in[i] + i;
  int sum = 0;
  for (int i = 0; i < 16; i += 4) {
#pragma HLS PIPELINE II=1
    sum += words[i] * words[i + 1] - words[i + 2] * words[i + 3];
  }
  return sum;
}
