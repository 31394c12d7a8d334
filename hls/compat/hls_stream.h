/// hls::stream for C simulation: an unbounded first-in first-out queue that cannot be copied and has a name.
/// A ring buffer that only grows; no locks: processes run one after the other, as a C program does, and tasks
/// (hls_task.h) when somebody waits.
#ifndef HLS_STREAM_H
#define HLS_STREAM_H

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace hls {

/// Misuse of a stream in C simulation that would hang the hardware.
class stream_error : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

namespace stream_detail {

/// What the streams of a program have in common; a template, so that it needs no source file.
template <class Unused = void>
struct Shared {
  static unsigned long long transfers;  ///< Elements that any stream took or gave.
  static bool (*others)();              ///< Lets tasks work; false when none moved an element. Null: no tasks.

  static bool others_moved() { return others && others(); }
};
template <class Unused>
unsigned long long Shared<Unused>::transfers = 0;
template <class Unused>
bool (*Shared<Unused>::others)() = nullptr;

}  // namespace stream_detail

/// DEPTH is what the FIFO of the hardware holds; C simulation takes any number of elements unless bound() is
/// called.
template <class T, int DEPTH = 0>
class stream;

template <class T>
class stream<T, 0> {
 public:
  stream() : stream("unnamed") {}
  explicit stream(const char* name) : name_(name) {}
  stream(const stream&) = delete;
  stream& operator=(const stream&) = delete;

  const std::string& name() const { return name_; }
  void set_name(const char* name) { name_ = name; }

  bool empty() const {
    if (count_ == 0) stream_detail::Shared<>::others_moved();
    return count_ == 0;
  }
  bool full() const { return count_ == bound_; }
  /// Elements written and not read yet; not 0 at the end of a test is a leftover.
  std::size_t size() const { return count_; }
  /// Elements the stream takes before it is full.
  std::size_t capacity() const { return bound_; }
  /// From now on the stream is full at `elements`, as a FIFO of that depth is.
  void bound(std::size_t elements) { bound_ = elements; }

  T read() {
    T value;
    read(value);
    return value;
  }
  void read(T& value) {
    while (count_ == 0 && stream_detail::Shared<>::others_moved()) {
    }
    if (!read_nb(value)) {
      throw stream_error("Stream \"" + name_ +
                         "\" is read while it is empty; write to it before, or read less.");
    }
  }
  bool read_nb(T& value) {
    if (empty()) return false;
    value = ring_[first_];
    first_ = (first_ + 1) & (ring_size_ - 1);
    --count_;
    ++stream_detail::Shared<>::transfers;
    return true;
  }
  void operator>>(T& value) { read(value); }

  void write(const T& value) {
    if (!write_nb(value)) {
      throw stream_error("Stream \"" + name_ + "\" is written while its " + std::to_string(bound_) +
                         " places are full; make it deeper, or read from it before.");
    }
  }
  bool write_nb(const T& value) {
    if (full()) return false;
    if (count_ == ring_size_) grow();
    ring_[(first_ + count_) & (ring_size_ - 1)] = value;
    ++count_;
    ++stream_detail::Shared<>::transfers;
    return true;
  }
  void operator<<(const T& value) { write(value); }

 private:
  void grow() {
    const std::size_t larger_size = ring_size_ ? 2 * ring_size_ : 16;
    std::unique_ptr<T[]> larger(new T[larger_size]);
    for (std::size_t i = 0; i < count_; ++i) larger[i] = ring_[(first_ + i) & (ring_size_ - 1)];
    ring_ = std::move(larger);
    ring_size_ = larger_size;
    first_ = 0;
  }

  std::string name_;
  std::unique_ptr<T[]> ring_;
  std::size_t ring_size_ = 0;  // a power of two
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  std::size_t bound_ = static_cast<std::size_t>(-1);
};

template <class T, int DEPTH>
class stream : public stream<T, 0> {
 public:
  stream() = default;
  explicit stream(const char* name) : stream<T, 0>(name) {}
};

}  // namespace hls

#endif
