// A constant pointer into an array, and pointer arithmetic.
// top: array_pointer_into
int array_pointer_into(const int a[16], int at) {
  const int* half = a + 8;
  const int* element = half + (at & 7);
  return *element + half[0] + a[1];
}
