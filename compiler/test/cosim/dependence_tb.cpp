void dependence(const unsigned char values[16], int result[64]);
int main() {
  unsigned char values[16];
  for (int i = 0; i < 16; ++i) values[i] = i / 3;
  int result[64];
  dependence(values, result);
  return 0;  // What the results are is not defined.
}
