/// hls::stream_of_blocks as the compiler sees it: the place of one block, of which the channel between the
/// processes has several banks, and two streams of tokens by which an end takes a bank and gives it away.
#ifndef HLSC_INCLUDE_HLS_STREAMOFBLOCKS_H
#define HLSC_INCLUDE_HLS_STREAMOFBLOCKS_H

#include <detail/block_locks.h>

#include "hls_stream.h"

// As the primitives of hls_stream.h; what accesses the object that holds the stream does not pass them.
template <class T>
void __hls_stream_read_lock(const void* stream, T* value) noexcept;
template <class T>
void __hls_stream_write_lock(const void* stream, const T* value) noexcept;

namespace hls {

template <class T>
class stream_of_blocks<T, 0> {
 public:
  stream_of_blocks() {}
  explicit stream_of_blocks(const char*) {}

  T& write_acquire() {
    give(claims_);
    return block_;
  }
  void write_release() { give(filled_); }
  T& read_acquire() {
    take(filled_);
    return block_;
  }
  void read_release() { take(claims_); }

  bool empty() const { return filled_.empty(); }
  bool full() const { return claims_.full(); }

 private:
  stream_of_blocks(const stream_of_blocks&);
  stream_of_blocks& operator=(const stream_of_blocks&);

  static void give(const stream<bool>& tokens) {
    const bool token = true;
    __hls_stream_write_lock<bool>(&tokens, &token);
  }
  static void take(const stream<bool>& tokens) {
    bool token;
    __hls_stream_read_lock<bool>(&tokens, &token);
  }

  stream<bool> claims_;  ///< A token for every block from write_acquire to read_release.
  stream<bool> filled_;  ///< A token for every block that waits for the reader.
  T block_;              ///< The locked one: either process has its own.
};

template <class T, int DEPTH>
class stream_of_blocks : public stream_of_blocks<T, 0> {
 public:
  stream_of_blocks() { declare_depth(); }
  explicit stream_of_blocks(const char*) { declare_depth(); }

 private:
  void declare_depth() { __hls_pragma("STREAM depth=$0", "", this, static_cast<long>(DEPTH)); }
};

}  // namespace hls

#endif
