#include "struct_with_arrays.h"

int main() {
  Image in, out;
  Filter filter;
  int values[8];
  for (int i = 0; i < 8; ++i) {
    filter.state[i].value = values[i] = i * 5;
    filter.state[i].weight = 3 - i;
  }
  for (int call = 0; call < 6; ++call) {
    for (int i = 0; i < 16; ++i) in.pixels[i / 4][i % 4] = 100 * i + call;
    in.gain = 40 - 13 * call;
    struct_with_arrays(in, out, &filter);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x)
        if (out.pixels[y][x] != ap_uint<12>(in.pixels[x][y] + in.gain)) return 1;
    int expected = 0;
    for (int i = 7; i > 0; --i) values[i] = values[i - 1];
    values[0] = in.gain;
    for (int i = 0; i < 8; ++i) expected += values[i] * (3 - i);
    if (out.gain != 2 * in.gain || filter.sum != expected) return 1;
  }
  return 0;
}
