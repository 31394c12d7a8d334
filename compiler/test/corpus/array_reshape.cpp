// Reshaped array: as many elements a cycle as banks.
// top: array_reshape
// expect: memory words registers 4x8 count=4
int array_reshape(const unsigned char in[16]) {
  unsigned char words[16];
#pragma HLS ARRAY_RESHAPE variable=words cyclic factor=4
  for (int i = 0; i < 16; ++i) words[i] = in[i] + i;
  int sum = 0;
  for (int i = 0; i < 16; i += 4) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    sum += words[i] * words[i + 1] - words[i + 2] * words[i + 3];
  }
  return sum;
}
