// PIPELINE of a top with ap_start: the next call begins, with its arguments, before this one is done.
// top: calls_result
// calls: 60
// expect: latency 3
int calls_result(int a, int b, short c) {  // expect: loop II=1 depth=3
#pragma HLS PIPELINE II=1
  static int sum = 5;
  int product = a * b;
  sum ^= c;
  return product * c + sum;
}
