// A static array with initial values, changed later.
// top: array_static_initialised
// calls: 10
int array_static_initialised(unsigned char i) {
  static int memory[4] = {10, 20, 30, 40};
  memory[i & 3] += 1;
  return memory[(i >> 2) & 3];
}
