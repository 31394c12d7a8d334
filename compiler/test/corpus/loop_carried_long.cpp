// A recurrence longer than a clock: the II follows from it.
// top: loop_carried_long
int loop_carried_long(const int a[24]) {
  int x = 1;
  for (int i = 0; i < 24; ++i) {  // expect: loop II=3 because 'x_2'
#pragma HLS PIPELINE
    x = (x * a[i]) ^ (x >> 3);
  }
  return x;
}
