// Error diffusion along a row: a recurrence through arithmetic.
// top: textbook_floyd_steinberg_row
void textbook_floyd_steinberg_row(const unsigned char in[32], bool out[32]) {
  int error = 0;
  for (int i = 0; i < 32; ++i) {  // expect: loop II=2 because 'error
#pragma HLS PIPELINE II=1
    int value = in[i] + error;
    out[i] = value > 127;
    error = (value - (out[i] ? 255 : 0)) * 7 / 16;
  }
}
