// An array in, an array out.
// top: array_copy
void array_copy(const int a[32], int b[32]) {
COPY:
  for (int i = 0; i < 32; ++i) b[31 - i] = a[i] + 1;  // expect: loop II=1 depth=2 cycles=33
}
