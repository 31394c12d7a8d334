// Insertion sort in place.
// top: textbook_insertion_sort
void textbook_insertion_sort(int a[16]) {
OUTER:
  for (int i = 1; i < 16; ++i) {
    int item = a[i];
    int j = i;
  INNER:
    while (j > 0 && a[j - 1] > item) {  // expect: loop II=1
#pragma HLS PIPELINE
      a[j] = a[j - 1];
      --j;
    }
    a[j] = item;
  }
}
