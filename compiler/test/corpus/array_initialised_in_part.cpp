// Arrays of which the first elements have a value and the others are zero, of one and two dimensions, written and
// constant, of structs and in structs.
// top: array_initialised_in_part
struct Pair {
  short a, b;
};
static const int kTable[256] = {3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8, 9, 7, 9, 3};
static const short kRows[8][40] = {{1, -2, 3}, {}, {4, 5}, {6}};
struct Settings {
  int taps[32];
  short gain;
};
static const Settings kSettings[3] = {{{4, 5}, 1}, {{6}, 2}};
static const Pair kPairs[64] = {{1, 2}, {3, 4}};
void array_initialised_in_part(const int in[64], int out[64]) {
  static int counts[128] = {100, 200};
  for (int i = 0; i < 64; ++i) {
    int x = in[i];
    int& count = counts[x & 127];
    count += 1;
    out[i] = kTable[(x >> 4) & 255] + 10 * kRows[(x >> 3) & 7][(x & 63) % 40] + 1000 * kPairs[(x >> 5) & 63].b +
             kTable[i & 15] * kRows[i & 3][i & 1] * kPairs[i & 1].a + count +
             kSettings[i % 3].taps[x & 31] * kSettings[(x & 1) + 1].gain;
  }
}
