// Values that live for several initiation intervals: each is kept in as few registers as iterations overlap.
// top: loop_values_outlive_ii
int loop_values_outlive_ii(const int a[40], int scale) {
  static int memory[8];
  int sum = 0;
  for (int i = 0; i < 40; ++i) {  // expect: loop II=3
#pragma HLS PIPELINE II=3
    const int first = a[i];
    const int product = first * scale;
    const int square = product * (product >> 3);
    memory[i & 7] = square + i;
    sum = (sum ^ first) + memory[(i + 3) & 7] - (square >> 5) + i;
  }
  return sum;
}
