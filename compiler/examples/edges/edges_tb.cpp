/// A picture with a bright square: two pictures in a row must give the same edges as plain C.
#include <cstdio>
#include <cstdlib>

#include "edges.h"

const int kHeight = 24, kWidth = 40;

static int grey(int y, int x) {
  return y > 8 && y < 16 && x > 10 && x < 30 ? 200 : 20 + (x * 7 + y * 3) % 16;
}

static int expected(int y, int x) {
  if (y < 2 || x < 2) return 0;
  int strength =
      std::abs(grey(y - 1, x) - grey(y - 1, x - 2)) + std::abs(grey(y, x - 1) - grey(y - 2, x - 1));
  return strength > 255 ? 255 : strength;
}

int main() {
  hls::stream<pixel_t> in("in"), out("out");
  for (int picture = 0; picture < 2; ++picture) {
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        pixel_t pixel;
        pixel.data = grey(y, x);
        pixel.keep = pixel.strb = 1;
        pixel.user = y == 0 && x == 0;
        pixel.last = x == kWidth - 1;
        in.write(pixel);
      }
    edges(in, out, kHeight, kWidth);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        pixel_t pixel = out.read();
        if (pixel.data == expected(y, x) && pixel.last == (x == kWidth - 1)) continue;
        std::printf("picture %d, row %d, column %d: %d, not %d\n", picture, y, x, (int)pixel.data,
                    expected(y, x));
        return 1;
      }
  }
  return 0;
}
