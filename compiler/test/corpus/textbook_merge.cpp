// Merge of two sorted halves.
// top: textbook_merge
void textbook_merge(const int a[16], int out[16]) {
  int i = 0, j = 8;
  for (int k = 0; k < 16; ++k) {
#pragma HLS PIPELINE
    if (j >= 16 || (i < 8 && a[i] <= a[j]))
      out[k] = a[i++];
    else
      out[k] = a[j++];
  }
}
