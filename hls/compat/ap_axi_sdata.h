/// AXI4-Stream elements: a word of data and the side channels of the bus.
#ifndef AP_AXI_SDATA_H
#define AP_AXI_SDATA_H

#include "ap_int.h"

namespace hls {

/// A side channel of W bits that the port does not have when W is 0.
template <int W>
struct SideChannel {
  typedef ap_uint<W> type;
};
template <>
struct SideChannel<0> {
  struct type {
    AP_INLINE operator unsigned() const { return 0; }
    template <class T>
    AP_INLINE type& operator=(const T&) {
      return *this;
    }
  };
};

/// Bits of a data type: ap types know theirs, native ones have all their bytes.
template <class T, bool IsNative = std::is_arithmetic<T>::value>
struct DataWidth {
  static const int value = T::width;
};
template <class T>
struct DataWidth<T, true> {
  static const int value = 8 * sizeof(T);
};

/// keep and strb hold a bit per byte of data; last ends a packet (in video: a line), user starts a frame.
template <class T, int WUser, int WId, int WDest, int WData = DataWidth<T>::value>
struct axis {
  T data;
  ap_uint<(WData + 7) / 8> keep;
  ap_uint<(WData + 7) / 8> strb;
  typename SideChannel<WUser>::type user;
  ap_uint<1> last;
  typename SideChannel<WId>::type id;
  typename SideChannel<WDest>::type dest;
};

}  // namespace hls

template <int WData, int WUser = 0, int WId = 0, int WDest = 0>
using ap_axiu = hls::axis<ap_uint<WData>, WUser, WId, WDest>;
template <int WData, int WUser = 0, int WId = 0, int WDest = 0>
using ap_axis = hls::axis<ap_int<WData>, WUser, WId, WDest>;

#endif
