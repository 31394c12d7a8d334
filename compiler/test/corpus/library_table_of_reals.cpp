// A loop that fills a table with a function of real numbers: they are calculated at compile time.
// top: library_table_of_reals
#include <cmath>
static void fill(short table[32]) {
  for (int i = 0; i < 32; ++i) table[i] = static_cast<short>(32767.0 * std::sin(3.14159265358979 * i / 64.0));
}
int library_table_of_reals(unsigned char x, short gain) {
  short table[32];
  fill(table);
  return table[x & 31] * gain;
}
