/// Channels between one task and several: hls::split gives each element of `in` to one of the streams `out`,
/// hls::merge brings those of the streams `in` to `out`. N of the streams, of type T; depths as declared.
#ifndef HLS_NP_CHANNEL_H
#define HLS_NP_CHANNEL_H

#include <hls_stream.h>
#include <hls_task.h>  // not the one beside it: the compiler has its own

namespace hls {
namespace np_detail {

template <class T, int N, int IN_DEPTH, int OUT_DEPTH>
void split_in_turn(stream<T, IN_DEPTH>& in, stream<T, OUT_DEPTH> (&out)[N]) {
  for (int i = 0; i < N; ++i) out[i].write(in.read());
}

template <class T, int N, int IN_DEPTH, int OUT_DEPTH>
void split_where_room_is(stream<T, IN_DEPTH>& in, stream<T, OUT_DEPTH> (&out)[N]) {
  const T value = in.read();
  bool waits = true;
  while (waits)
    for (int i = 0; i < N; ++i)
      if (waits && out[i].write_nb(value)) waits = false;
}

template <class T, int N, int IN_DEPTH, int OUT_DEPTH>
void merge_in_turn(stream<T, IN_DEPTH> (&in)[N], stream<T, OUT_DEPTH>& out) {
  for (int i = 0; i < N; ++i) out.write(in[i].read());
}

template <class T, int N, int IN_DEPTH, int OUT_DEPTH>
void merge_what_is_there(stream<T, IN_DEPTH> (&in)[N], stream<T, OUT_DEPTH>& out) {
  for (int i = 0; i < N; ++i)
    if (!in[i].empty()) out.write(in[i].read());
}

}  // namespace np_detail

namespace split {

/// Element i goes to out[i % N].
template <class T, int N, int IN_DEPTH = 2, int OUT_DEPTH = 2>
class round_robin {
 public:
  stream<T, IN_DEPTH> in;
  stream<T, OUT_DEPTH> out[N];

  round_robin() { worker_(np_detail::split_in_turn<T, N, IN_DEPTH, OUT_DEPTH>, in, out); }

 private:
  task worker_;
};

/// An element goes to the first stream that has room.
template <class T, int N, int IN_DEPTH = 2, int OUT_DEPTH = 2>
class load_balance {
 public:
  stream<T, IN_DEPTH> in;
  stream<T, OUT_DEPTH> out[N];

  load_balance() { worker_(np_detail::split_where_room_is<T, N, IN_DEPTH, OUT_DEPTH>, in, out); }

 private:
  task worker_;
};

}  // namespace split

namespace merge {

/// Element i comes from in[i % N].
template <class T, int N, int IN_DEPTH = 2, int OUT_DEPTH = 2>
class round_robin {
 public:
  stream<T, IN_DEPTH> in[N];
  stream<T, OUT_DEPTH> out;

  round_robin() { worker_(np_detail::merge_in_turn<T, N, IN_DEPTH, OUT_DEPTH>, in, out); }

 private:
  task worker_;
};

/// Elements come in the order in which they are there.
template <class T, int N, int IN_DEPTH = 2, int OUT_DEPTH = 2>
class load_balance {
 public:
  stream<T, IN_DEPTH> in[N];
  stream<T, OUT_DEPTH> out;

  load_balance() { worker_(np_detail::merge_what_is_there<T, N, IN_DEPTH, OUT_DEPTH>, in, out); }

 private:
  task worker_;
};

}  // namespace merge
}  // namespace hls

#endif
