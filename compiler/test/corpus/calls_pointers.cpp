// Scalars behind pointers, one of them read and written: what a call sets comes in the order of the calls.
// top: calls_pointers
// calls: 60
void calls_pointers(int a, int* b, short& c, int* d) {  // expect: loop II=2
#pragma HLS PIPELINE II=2
  static int n;
  *b += a * n;
  if (a & 1) c = *b;
  *d = 7;
  ++n;
  if (a * a * n & 8) *d = a;
}
