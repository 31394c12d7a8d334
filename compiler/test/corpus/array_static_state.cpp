// A static array keeps its contents across calls.
// top: array_static_state
// calls: 12
// expect: memory memory ram 8x32
int array_static_state(unsigned char address, int value) {
  static int memory[8];
  int old = memory[address & 7];
  memory[address & 7] = value;
  return old;
}
