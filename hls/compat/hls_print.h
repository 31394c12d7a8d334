/// hls::print: printf in C simulation, nothing in hardware.
#ifndef HLS_PRINT_H
#define HLS_PRINT_H

#include <cstdio>

namespace hls {

template <class... Values>
void print(const char* format, Values... values) {
#ifndef __SYNTHESIS__
  std::printf(format, values...);
#endif
}

}  // namespace hls

#endif
