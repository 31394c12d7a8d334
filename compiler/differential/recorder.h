/// What every generated native program shares: random arguments of a call, and files of hexadecimal words
/// that a Verilog bench reads with $readmemh. Precompiled with the types of hls/compat.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "ap_axi_sdata.h"
#include "ap_fixed.h"
#include "ap_int.h"
#include "hls_stream.h"

namespace recorder {

/// One scalar inside an object: bits [0, width) of the `bytes` at `offset`.
struct Leaf {
  unsigned offset, bytes, width;
  bool is_signed;
};

/// Bounds of random values; `is_given` false: all values of the leaf.
struct Range {
  bool is_given;
  long long low, high;
};

inline std::mt19937_64 generator;

/// The type behind parameter I of a function, without reference and const.
template <class Function>
struct Signature;
template <class Result, class... Parameters>
struct Signature<Result(Parameters...)> {
  template <std::size_t I>
  using Parameter = std::tuple_element_t<I, std::tuple<Parameters...>>;
};
template <class Function, std::size_t I>
using Object = std::remove_const_t<
    std::remove_pointer_t<std::remove_reference_t<typename Signature<Function>::template Parameter<I>>>>;

/// 64 random bits; small, nearly full and one-bit values are frequent, since they find the borders.
inline std::uint64_t random_word(int flavour) {
  std::uint64_t word = generator();
  if (flavour == 1) return word & 15;
  if (flavour == 2) return ~(word & 15);
  if (flavour == 3) return std::uint64_t{1} << (word & 63);
  return word;
}

inline void fill_leaf(unsigned char* object, const Leaf& leaf, Range range) {
  const int flavour = static_cast<int>(generator() % 8);
  unsigned char* bytes = object + leaf.offset;
  std::uint64_t word = 0;
  for (unsigned i = 0; i < leaf.bytes; ++i) {
    if (i % 8 == 0)
      word = range.is_given
                 ? (i ? (range.low < 0 ? ~0ull : 0) : range.low + generator() % (range.high - range.low + 1))
                 : random_word(i && flavour != 2 && flavour < 4 ? 1 : flavour);
    bytes[i] = static_cast<unsigned char>(word >> i % 8 * 8);
  }
  // The bits beyond the width repeat the sign or are zero.
  const bool sign = leaf.is_signed && (bytes[(leaf.width - 1) / 8] >> (leaf.width - 1) % 8 & 1);
  for (unsigned i = leaf.width; i < leaf.bytes * 8; ++i)
    bytes[i / 8] = static_cast<unsigned char>((bytes[i / 8] & ~(1u << i % 8)) | unsigned{sign} << i % 8);
}

/// Fills `count` objects of `stride` bytes.
inline void fill(void* objects, std::size_t count, std::size_t stride, const std::vector<Leaf>& leaves,
                 Range range) {
  for (std::size_t i = 0; i < count; ++i)
    for (const Leaf& leaf : leaves) fill_leaf(static_cast<unsigned char*>(objects) + i * stride, leaf, range);
}

/// A file of one word a line.
class Words {
 public:
  explicit Words(const std::string& path) : file_(std::fopen(path.c_str(), "w")) {
    if (!file_) std::exit(2);
  }
  ~Words() {
    if (count_ == 0) std::fputs("0\n", file_);  // $readmemh wants at least one.
    std::fclose(file_);
  }
  Words(const Words&) = delete;
  Words& operator=(const Words&) = delete;

  void number(std::uint64_t value) {
    std::fprintf(file_, "%llx\n", static_cast<unsigned long long>(value));
    ++count_;
  }
  /// The leaves packed, the first one lowest.
  void object(const void* object, const std::vector<Leaf>& leaves) {
    const unsigned char* bytes = static_cast<const unsigned char*>(object);
    std::vector<bool> bits;
    for (const Leaf& leaf : leaves)
      for (unsigned i = 0; i < leaf.width; ++i) bits.push_back(bytes[leaf.offset + i / 8] >> i % 8 & 1);
    while (bits.size() % 4) bits.push_back(false);
    for (std::size_t i = bits.size(); i > 0; i -= 4)
      std::fputc(
          "0123456789abcdef"[bits[i - 1] << 3 | bits[i - 2] << 2 | bits[i - 3] << 1 | int{bits[i - 4]}],
          file_);
    std::fputc('\n', file_);
    ++count_;
  }
  std::size_t count() const { return count_; }

 private:
  std::FILE* file_;
  std::size_t count_ = 0;
};

}  // namespace recorder
