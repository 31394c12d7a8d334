/// c = a * b for matrices of small integers, and the trace of c.
const int kSize = 8;

void matrix(const short a[kSize][kSize], const short b[kSize][kSize], int c[kSize][kSize], int* trace);
