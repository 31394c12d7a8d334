/// hls::stream for C simulation with the declared FIFO depths (csim --finite-fifos): read and write wait as
/// in hardware, while the other processes of the DATAFLOW function go on (processes.h).
#ifndef HLSC_FINITE_HLS_STREAM_H
#define HLSC_FINITE_HLS_STREAM_H

#include <cstddef>
#include <deque>
#include <string>

#include "processes.h"

namespace hls {

template <class T, int DEPTH = 0>
class stream;

template <class T>
class stream<T, 0> : private hlsc_finite::Fifo {
 public:
  typedef T value_type;

  stream() {}
  explicit stream(const char* name) { set_name(name); }
  stream(const stream&) = delete;
  stream& operator=(const stream&) = delete;
  /// The processes that were called with the stream end before it does.
  ~stream() { hlsc_join(); }

  const std::string& name() const { return Fifo::name; }
  void set_name(const char* name) { Fifo::name = name; }

  bool empty() const { return !const_cast<stream*>(this)->wait(false, true); }
  bool full() const { return !const_cast<stream*>(this)->wait(true, true); }
  std::size_t size() const { return held; }
  std::size_t capacity() const { return places(); }

  T read() {
    wait(false, false);
    return take();
  }
  void read(T& value) { value = read(); }
  void operator>>(T& value) { value = read(); }
  bool read_nb(T& value) {
    if (empty()) return false;
    value = take();
    return true;
  }
  void write(const T& value) {
    wait(true, false);
    put(value);
  }
  void operator<<(const T& value) { write(value); }
  bool write_nb(const T& value) {
    if (full()) return false;
    put(value);
    return true;
  }

 protected:
  explicit stream(std::size_t depth) { declared = depth; }

 private:
  T take() {
    T value = values_.front();
    values_.pop_front();
    --held;
    moved();
    return value;
  }
  void put(const T& value) {
    values_.push_back(value);
    ++held;
    moved();
  }

  std::deque<T> values_;
};

template <class T, int DEPTH>
class stream : public stream<T, 0> {
 public:
  stream() : stream<T, 0>(static_cast<std::size_t>(DEPTH)) {}
  explicit stream(const char* name) : stream() { this->set_name(name); }
};

}  // namespace hls

#endif
