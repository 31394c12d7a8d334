// Read and write of one argument array.
// top: array_in_place
void array_in_place(int a[16]) {
  for (int i = 1; i < 16; ++i) a[i] += a[i - 1];  // expect: loop II=2 because the read port of 'a'
}
