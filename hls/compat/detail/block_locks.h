/// The locks of hls::stream_of_blocks, by its methods write_acquire, write_release, read_acquire,
/// read_release.
#ifndef HLS_DETAIL_BLOCK_LOCKS_H
#define HLS_DETAIL_BLOCK_LOCKS_H

#include <utility>

namespace hls {

/// Blocks of type T, an array, of which DEPTH are locked or wait for the reader. What does not depend on
/// DEPTH is the base with DEPTH 0.
template <class T, int DEPTH = 2>
class stream_of_blocks;

namespace block_detail {

/// Either lock's block: as T&, or its elements by subscripts.
template <class T>
class Lock {
 public:
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

  operator T&() const { return block_; }
  template <class Index>
  auto operator[](Index index) const -> decltype((std::declval<T&>()[index])) {
    return block_[index];
  }

 protected:
  explicit Lock(T& block) : block_(block) {}
  ~Lock() = default;

 private:
  T& block_;
};

}  // namespace block_detail

/// A free block, which the writer fills until the end of the scope.
template <class T>
class write_lock : public block_detail::Lock<T> {
 public:
  explicit write_lock(stream_of_blocks<T, 0>& channel)
      : block_detail::Lock<T>(channel.write_acquire()), channel_(channel) {}
  ~write_lock() { channel_.write_release(); }

 private:
  stream_of_blocks<T, 0>& channel_;
};

/// The next filled block, which the reader has until the end of the scope.
template <class T>
class read_lock : public block_detail::Lock<T> {
 public:
  explicit read_lock(stream_of_blocks<T, 0>& channel)
      : block_detail::Lock<T>(channel.read_acquire()), channel_(channel) {}
  ~read_lock() { channel_.read_release(); }

 private:
  stream_of_blocks<T, 0>& channel_;
};

}  // namespace hls

#endif
