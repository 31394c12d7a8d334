// Structs outside whose member arrays are ports of their own, beside scalar members.
#include "struct_with_arrays.h"

void struct_with_arrays(const Image& in, Image& out, Filter* filter) {
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) out.pixels[y][x] = in.pixels[x][y] + in.gain;
  out.gain = in.gain * 2;
  for (int i = 7; i > 0; --i) filter->state[i].value = filter->state[i - 1].value;
  filter->state[0].value = in.gain;
  int sum = 0;
  for (int i = 0; i < 8; ++i) sum += filter->state[i].value * filter->state[i].weight;
  filter->sum = sum;
}
