// Arrays of pointers, chosen from at run time.
// top: array_of_pointers
static int sum(int* rows[4], int row, int count) {
  int total = 0;
  for (int i = 0; i < count; ++i) total += rows[row][i];
  return total;
}
void array_of_pointers(const int in[32], int out[4], unsigned char first) {
  static int a[8], b[8];
  int c[8], d[8];
  int* rows[4] = {a, b, c, d};
  for (int i = 0; i < 32; ++i) rows[i / 8][i % 8] = in[i] * (i + 1);
  int* turned[4];
  turned[0] = rows[3];
  turned[1] = b;
  turned[2] = first & 1 ? a : c;
  turned[3] = first & 1 ? c : a;
  for (int i = 0; i < 4; ++i) out[i] = sum(turned, (first + i) & 3, 8);
}
