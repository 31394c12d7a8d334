/// hls::stream_of_blocks for C simulation: a stream of whole arrays. Each end works on a block of its own,
/// which moves when its lock ends.
#ifndef HLS_STREAMOFBLOCKS_H
#define HLS_STREAMOFBLOCKS_H

#include <hls_stream.h>

#include "detail/block_locks.h"

namespace hls {

template <class T>
class stream_of_blocks<T, 0> {
 public:
  stream_of_blocks() = default;
  explicit stream_of_blocks(const char* name) : blocks_(name) {}

  T& write_acquire() { return written_.block; }
  void write_release() { blocks_.write(written_); }
  T& read_acquire() {
    blocks_.read(read_);
    return read_.block;
  }
  void read_release() {}

  bool empty() const { return blocks_.empty(); }
  bool full() const { return blocks_.full(); }

 private:
  struct Holder {
    T block;
  };

  stream<Holder, 2> blocks_;
  Holder written_, read_;
};

template <class T, int DEPTH>
class stream_of_blocks : public stream_of_blocks<T, 0> {
 public:
  stream_of_blocks() = default;
  explicit stream_of_blocks(const char* name) : stream_of_blocks<T, 0>(name) {}
};

}  // namespace hls

#endif
