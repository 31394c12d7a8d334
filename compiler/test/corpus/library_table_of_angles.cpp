// A table of angles that a constructor fills, with the real functions that LLVM has as intrinsics of its own.
// top: library_table_of_angles
#include <ap_fixed.h>
#include <cmath>
typedef ap_fixed<24, 4> Angle;
struct Rotator {
  Angle angles[12];
  Rotator() {
    double step = 1;
    for (int i = 0; i < 12; ++i) {
      angles[i] = std::atan(step);
      step *= 0.5;
    }
  }
};
Angle library_table_of_angles(unsigned char x, short factor) {
  static const Rotator rotator;
  Angle small[8];
  for (int i = 0; i < 8; ++i) small[i] = std::tanh(i / 8.0f) + std::acos(1 - i / 16.0);
  return rotator.angles[x % 12] * factor + small[x & 7];
}
