/// hls::vector<T, N>: N elements that are calculated with together, element by element.
#ifndef HLS_VECTOR_H
#define HLS_VECTOR_H

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace hls {

template <class T, std::size_t N>
class vector {
 public:
  typedef T value_type;

  vector() = default;
  /// The same value in every element.
  vector(const T& value) {
    for (std::size_t i = 0; i < N; ++i) {
#pragma HLS UNROLL
      elements_[i] = value;
    }
  }
  vector(std::initializer_list<T> values) { take(values.begin()); }
  vector(const T (&values)[N]) { take(values); }

  T& operator[](std::size_t i) { return elements_[i]; }
  const T& operator[](std::size_t i) const { return elements_[i]; }
  T* begin() { return elements_; }
  const T* begin() const { return elements_; }
  T* end() { return elements_ + N; }
  const T* end() const { return elements_ + N; }
  static constexpr std::size_t size() { return N; }

  vector& operator+=(const vector& b) {
    return apply(b, [](const T& x, const T& y) { return static_cast<T>(x + y); });
  }
  vector& operator-=(const vector& b) {
    return apply(b, [](const T& x, const T& y) { return static_cast<T>(x - y); });
  }
  vector& operator*=(const vector& b) {
    return apply(b, [](const T& x, const T& y) { return static_cast<T>(x * y); });
  }
  vector& operator/=(const vector& b) {
    return apply(b, [](const T& x, const T& y) { return static_cast<T>(x / y); });
  }
  vector& operator%=(const vector& b) {
    return apply(b, [](const T& x, const T& y) { return static_cast<T>(x % y); });
  }
  vector& operator&=(const vector& b) {
    return apply(b, [](const T& x, const T& y) { return static_cast<T>(x & y); });
  }
  vector& operator|=(const vector& b) {
    return apply(b, [](const T& x, const T& y) { return static_cast<T>(x | y); });
  }
  vector& operator^=(const vector& b) {
    return apply(b, [](const T& x, const T& y) { return static_cast<T>(x ^ y); });
  }
  vector& operator<<=(const vector& b) {
    return apply(b, [](const T& x, const T& y) { return static_cast<T>(x << y); });
  }
  vector& operator>>=(const vector& b) {
    return apply(b, [](const T& x, const T& y) { return static_cast<T>(x >> y); });
  }

  friend vector operator+(vector a, const vector& b) { return a += b; }
  friend vector operator-(vector a, const vector& b) { return a -= b; }
  friend vector operator*(vector a, const vector& b) { return a *= b; }
  friend vector operator/(vector a, const vector& b) { return a /= b; }
  friend vector operator%(vector a, const vector& b) { return a %= b; }
  friend vector operator&(vector a, const vector& b) { return a &= b; }
  friend vector operator|(vector a, const vector& b) { return a |= b; }
  friend vector operator^(vector a, const vector& b) { return a ^= b; }
  friend vector operator<<(vector a, const vector& b) { return a <<= b; }
  friend vector operator>>(vector a, const vector& b) { return a >>= b; }
  vector& operator++() { return *this += vector(T(1)); }
  vector& operator--() { return *this -= vector(T(1)); }

  friend bool operator==(const vector& a, const vector& b) {
    bool equal = true;
    for (std::size_t i = 0; i < N; ++i) {
#pragma HLS UNROLL
      equal &= a.elements_[i] == b.elements_[i];
    }
    return equal;
  }
  friend bool operator!=(const vector& a, const vector& b) { return !(a == b); }

  T reduce_add() const {
    return reduce([](const T& x, const T& y) { return static_cast<T>(x + y); });
  }
  T reduce_mult() const {
    return reduce([](const T& x, const T& y) { return static_cast<T>(x * y); });
  }
  T reduce_and() const {
    return reduce([](const T& x, const T& y) { return static_cast<T>(x & y); });
  }
  T reduce_or() const {
    return reduce([](const T& x, const T& y) { return static_cast<T>(x | y); });
  }
  T reduce_xor() const {
    return reduce([](const T& x, const T& y) { return static_cast<T>(x ^ y); });
  }

 private:
  void take(const T* values) {
    for (std::size_t i = 0; i < N; ++i) {
#pragma HLS UNROLL
      elements_[i] = values[i];
    }
  }
  template <class Operation>
  vector& apply(const vector& other, Operation operation) {
    for (std::size_t i = 0; i < N; ++i) {
#pragma HLS UNROLL
      elements_[i] = operation(elements_[i], other.elements_[i]);
    }
    return *this;
  }
  template <class Operation>
  T reduce(Operation operation) const {
    T result = elements_[0];
    for (std::size_t i = 1; i < N; ++i) {
#pragma HLS UNROLL
      result = operation(result, elements_[i]);
    }
    return result;
  }

  T elements_[N];
};

}  // namespace hls

#endif
