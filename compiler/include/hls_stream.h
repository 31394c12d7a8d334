/// hls::stream as the compiler sees it: an opaque handle whose accesses are primitives of the compiler.
/// (C simulation uses the project's or the vendor's own hls_stream.h.)
#ifndef HLSC_INCLUDE_HLS_STREAM_H
#define HLSC_INCLUDE_HLS_STREAM_H

#include <stdint.h>

// The compiler recognises these by name and takes the element's bit layout from T.
template <class T>
void __hls_stream_read(const void* stream, T* value) noexcept;
template <class T>
void __hls_stream_write(const void* stream, const T* value) noexcept;
template <class T>
bool __hls_stream_empty(const void* stream) noexcept;
template <class T>
bool __hls_stream_full(const void* stream) noexcept;

namespace hls {

template <class T, int DEPTH = 0>
class stream;

/// An unbounded FIFO in C, a FIFO of declared depth in hardware. Access through stream<T>& wherever DEPTH
/// does not matter.
template <class T>
class stream<T, 0> {
 public:
  typedef T value_type;

  stream() {}
  explicit stream(const char*) {}

  T read() {
    T value;
    __hls_stream_read<T>(this, &value);
    return value;
  }
  void read(T& value) { value = read(); }
  void operator>>(T& value) { value = read(); }
  void write(const T& value) { __hls_stream_write<T>(this, &value); }
  void operator<<(const T& value) { write(value); }

  bool empty() const { return __hls_stream_empty<T>(this); }
  bool full() const { return __hls_stream_full<T>(this); }
  bool read_nb(T& value) {
    if (empty()) return false;
    value = read();
    return true;
  }
  bool write_nb(const T& value) {
    if (full()) return false;
    write(value);
    return true;
  }

 private:
  stream(const stream&);
  stream& operator=(const stream&);

  char handle_;  ///< Gives the stream an address of its own.
};

template <class T, int DEPTH>
class stream : public stream<T, 0> {
 public:
  stream() { declare_depth(); }
  explicit stream(const char*) { declare_depth(); }

 private:
  void declare_depth() { __hls_pragma("STREAM depth=$0", "", this, static_cast<long>(DEPTH)); }
};

}  // namespace hls

#endif
