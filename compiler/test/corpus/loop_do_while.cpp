// do-while runs at least once.
// top: loop_do_while
int loop_do_while(unsigned short a) {
  int digits = 0;
  do {
    ++digits;
    a /= 10;
  } while (a);
  return digits;
}
