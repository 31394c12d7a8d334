// while with a data-dependent end: greatest common divisor.
// top: loop_while
// range: a=1..5000
// range: b=1..5000
// expect: latency N(while_3) * 12 + 3
int loop_while(int a, int b) {
  while (b != 0) {
    int t = a % b;
    a = b;
    b = t;
  }
  return a;
}
