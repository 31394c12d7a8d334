// An 8-point DCT by a coefficient table.
// top: textbook_dct8
// expect: memory kCosine logic 64x8
// expect: operators multiply=1
static const short kCosine[8][8] = {{64, 64, 64, 64, 64, 64, 64, 64},     {89, 75, 50, 18, -18, -50, -75, -89},
                                    {83, 36, -36, -83, -83, -36, 36, 83}, {75, -18, -89, -50, 50, 89, 18, -75},
                                    {64, -64, -64, 64, 64, -64, -64, 64}, {50, -89, 18, 75, -75, -18, 89, -50},
                                    {36, -83, 83, -36, -36, 83, -83, 36}, {18, -50, 75, -89, 89, -75, 50, -18}};
void textbook_dct8(const short in[8], int out[8]) {
  for (int k = 0; k < 8; ++k) {
    int sum = 0;
    for (int n = 0; n < 8; ++n) sum += kCosine[k][n] * in[n];  // expect: loop II=1
    out[k] = (sum + 128) >> 8;
  }
}
