/// Copies a stream of frames to two readers.
#ifndef FLOORLINE_HLS_DUPLICATE_H
#define FLOORLINE_HLS_DUPLICATE_H

#include "ap_int.h"
#include "hls_stream.h"

namespace floorline {

/// One frame of elements, up to and including the one whose `end` is set. II = 1.
template <typename Element>
void duplicate(hls::stream<Element>& in, hls::stream<Element>& first, hls::stream<Element>& second) {
  ap_uint<1> end = 0;
COPY:
  while (!end) {
#pragma HLS PIPELINE II = 1
    const Element element = in.read();
    first.write(element);
    second.write(element);
    end = element.end;
  }
}

}  // namespace floorline

#endif
