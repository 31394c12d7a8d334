/// AXI4-Stream elements: a word of data and the side channels of the bus.
#ifndef AP_AXI_SDATA_H
#define AP_AXI_SDATA_H

#include "ap_int.h"

// The channels of a stream, as bits of a set.
#define AXIS_ENABLE_DATA 0x01
#define AXIS_ENABLE_DEST 0x02
#define AXIS_ENABLE_ID 0x04
#define AXIS_ENABLE_KEEP 0x08
#define AXIS_ENABLE_LAST 0x10
#define AXIS_ENABLE_STRB 0x20
#define AXIS_ENABLE_USER 0x40
#define AXIS_ENABLE_ALL 0x7f
#define AXIS_DISABLE_DATA (0xff ^ AXIS_ENABLE_DATA)
#define AXIS_DISABLE_DEST (0xff ^ AXIS_ENABLE_DEST)
#define AXIS_DISABLE_ID (0xff ^ AXIS_ENABLE_ID)
#define AXIS_DISABLE_KEEP (0xff ^ AXIS_ENABLE_KEEP)
#define AXIS_DISABLE_LAST (0xff ^ AXIS_ENABLE_LAST)
#define AXIS_DISABLE_STRB (0xff ^ AXIS_ENABLE_STRB)
#define AXIS_DISABLE_USER (0xff ^ AXIS_ENABLE_USER)
#define AXIS_DISABLE_ALL 0x00

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
/// `Enable` is the sum of the channels that the port has.
template <class T, int WUser, int WId, int WDest, unsigned char Enable = AXIS_ENABLE_ALL, bool Strict = false>
struct axis {
  static const int bytes = (DataWidth<T>::value + 7) / 8;

  T data;
  typename SideChannel<Enable & AXIS_ENABLE_KEEP ? bytes : 0>::type keep;
  typename SideChannel<Enable & AXIS_ENABLE_STRB ? bytes : 0>::type strb;
  typename SideChannel<Enable & AXIS_ENABLE_USER ? WUser : 0>::type user;
  typename SideChannel<Enable & AXIS_ENABLE_LAST ? 1 : 0>::type last;
  typename SideChannel<Enable & AXIS_ENABLE_ID ? WId : 0>::type id;
  typename SideChannel<Enable & AXIS_ENABLE_DEST ? WDest : 0>::type dest;

  T get_data() const { return data; }
  void set_data(T value) { data = value; }
  decltype(keep) get_keep() const { return keep; }
  void set_keep(decltype(keep) value) { keep = value; }
  void keep_all() { keep = -1; }
  decltype(strb) get_strb() const { return strb; }
  void set_strb(decltype(strb) value) { strb = value; }
  decltype(user) get_user() const { return user; }
  void set_user(decltype(user) value) { user = value; }
  decltype(last) get_last() const { return last; }
  void set_last(decltype(last) value) { last = value; }
  decltype(id) get_id() const { return id; }
  void set_id(decltype(id) value) { id = value; }
  decltype(dest) get_dest() const { return dest; }
  void set_dest(decltype(dest) value) { dest = value; }
};

template <class T, unsigned char Enable = AXIS_ENABLE_KEEP | AXIS_ENABLE_LAST | AXIS_ENABLE_STRB>
using axis_data = axis<T, 0, 0, 0, Enable>;

}  // namespace hls

template <int WData, int WUser = 0, int WId = 0, int WDest = 0, unsigned char Enable = AXIS_ENABLE_ALL>
using ap_axiu = hls::axis<ap_uint<WData>, WUser, WId, WDest, Enable>;
template <int WData, int WUser = 0, int WId = 0, int WDest = 0, unsigned char Enable = AXIS_ENABLE_ALL>
using ap_axis = hls::axis<ap_int<WData>, WUser, WId, WDest, Enable>;

#endif
