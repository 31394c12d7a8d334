// A static const array becomes a ROM.
// top: array_const_table
// range: i=0..15
// expect: memory sine logic 16x8
// expect: latency 2
int array_const_table(unsigned char i) {
  static const short sine[16] = {0, 49, 90, 117, 127, 117, 90, 49, 0, -49, -90, -117, -127, -117, -90, -49};
  return sine[i] - sine[(i + 4) & 15];
}
