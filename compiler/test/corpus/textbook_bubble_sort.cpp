// Bubble sort on a local copy.
// top: textbook_bubble_sort
void textbook_bubble_sort(const short in[12], short out[12]) {
  short a[12];
  for (int i = 0; i < 12; ++i) a[i] = in[i];
  for (int i = 0; i < 11; ++i)
    for (int j = 0; j < 11 - i; ++j)  // expect: loop II=3 because the read port of 'a'
      if (a[j] > a[j + 1]) {
        short t = a[j];
        a[j] = a[j + 1];
        a[j + 1] = t;
      }
  for (int i = 0; i < 12; ++i) out[i] = a[i];
}
