/// What every generated co-simulation adapter shares: packing of C++ values, clocking, streams with random
/// stalls, memories. Included by the adapter only; needs Verilator's headers before it.
#ifndef HLSC_COSIM_HARNESS_H
#define HLSC_COSIM_HARNESS_H

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace hlsc_cosim {

/// A value of any width, least significant word first.
using Bits = std::vector<uint32_t>;

inline Bits zero_bits(unsigned width) { return Bits((width + 31) / 32 + 1, 0); }

inline bool get_bit(const Bits& bits, unsigned index) { return bits[index / 32] >> (index % 32) & 1; }
inline void set_bit(Bits& bits, unsigned index, bool value) {
  bits[index / 32] = (bits[index / 32] & ~(1u << index % 32)) | (uint32_t{value} << index % 32);
}

/// Bits [low, low + width).
inline Bits slice(const Bits& bits, unsigned low, unsigned width) {
  Bits part = zero_bits(width);
  for (unsigned i = 0; i < width; ++i) set_bit(part, i, get_bit(bits, low + i));
  return part;
}
/// Sets bits [low, low + width) of `bits` to `part`.
inline void place(Bits& bits, unsigned low, unsigned width, const Bits& part) {
  for (unsigned i = 0; i < width; ++i) set_bit(bits, low + i, get_bit(part, i));
}

/// Copies `width` bits of an object in memory to bits [low, low + width).
inline void pack(Bits& bits, unsigned low, unsigned width, const void* object, size_t offset) {
  const unsigned char* bytes = static_cast<const unsigned char*>(object) + offset;
  for (unsigned i = 0; i < width; ++i) set_bit(bits, low + i, bytes[i / 8] >> (i % 8) & 1);
}

/// The inverse of pack; fills the leaf's `size` bytes, with the sign where it is signed.
inline void unpack(const Bits& bits, unsigned low, unsigned width, bool is_signed, void* object,
                   size_t offset, size_t size) {
  unsigned char* bytes = static_cast<unsigned char*>(object) + offset;
  bool fill = is_signed && get_bit(bits, low + width - 1);
  for (unsigned i = 0; i < size * 8; ++i) {
    bool bit = i < width ? get_bit(bits, low + i) : fill;
    bytes[i / 8] = (bytes[i / 8] & ~(1u << i % 8)) | (bit << i % 8);
  }
}

template <class Signal>
void put(Signal& signal, const Bits& bits) {
  uint64_t value = bits[0] | (bits.size() > 1 ? uint64_t{bits[1]} << 32 : 0);
  signal = static_cast<Signal>(value);
}
template <size_t N>
void put(VlWide<N>& signal, const Bits& bits) {
  for (size_t i = 0; i < N; ++i) signal[i] = i < bits.size() ? bits[i] : 0;
}
template <class Signal>
Bits get(const Signal& signal, unsigned width) {
  Bits bits = zero_bits(width);
  bits[0] = static_cast<uint32_t>(signal);
  if (bits.size() > 1) bits[1] = static_cast<uint32_t>(static_cast<uint64_t>(signal) >> 32);
  return bits;
}
template <size_t N>
Bits get(const VlWide<N>& signal, unsigned width) {
  Bits bits = zero_bits(width);
  for (size_t i = 0; i < N && i < bits.size(); ++i) bits[i] = signal[i];
  return bits;
}

/// Decides when ports stall; HLSC_STALL is the seed, 0 or nothing: never.
class StallGenerator {
 public:
  StallGenerator()
      : state_(std::getenv("HLSC_STALL") ? std::strtoull(std::getenv("HLSC_STALL"), nullptr, 0) : 0) {}
  /// Long and short pauses alternate, so that FIFOs run both empty and full.
  bool stall() {
    if (state_ == 0) return false;
    if (pause_ == 0) {
      threshold_ = next() % 4 * 80;
      pause_ = 1 + next() % 64;
    }
    --pause_;
    return next() % 256 < threshold_;
  }

 private:
  uint64_t next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return state_ >> 20;
  }
  uint64_t state_;
  uint64_t threshold_ = 0;
  unsigned pause_ = 0;
};

/// One stream port. The generated code moves its signals before and after the clock edge.
struct StreamPort {
  std::string name;
  std::deque<Bits> tokens;  ///< Waiting to go in, or come out in this call.
  StallGenerator stalls;
  bool offered = false;  ///< An input: valid is up and must stay up. An output: ready is up.
  uint64_t transfers = 0;

  /// Whether an input offers a token in this cycle.
  bool offers() {
    if (tokens.empty()) return false;
    if (!offered) offered = !stalls.stall();
    return offered;
  }
  void taken() {
    tokens.pop_front();
    offered = false;
    ++transfers;
  }
};

/// The interrupt of a model. Verilator gives the signal another name where it keeps `interrupt` for C++.
template <class Model>
auto interrupt_of(const Model& model, int) -> decltype(bool(model.interrupt)) {
  return model.interrupt;
}
template <class Model>
auto interrupt_of(const Model& model, long) -> decltype(bool(model.__SYM__interrupt)) {
  return model.__SYM__interrupt;
}

/// An AXI4-Lite master: a transfer at a time, one clock cycle a step. `Bus` moves the signals of one port.
template <class Bus>
class AxiliteMaster {
 public:
  /// Clocks until the transfer is over; `cycle` settles and clocks the design, and calls what it is given
  /// between.
  template <class Cycle>
  static void write(uint64_t address, uint32_t data, Cycle cycle) {
    Bus::write_address(address, true);
    wait(cycle, [] { return Bus::address_taken(); });
    Bus::write_address(0, false);
    Bus::write_data(data, true);
    wait(cycle, [] { return Bus::data_taken(); });
    Bus::write_data(0, false);
    Bus::take_response(true);
    wait(cycle, [] { return Bus::response(); });
    Bus::take_response(false);
  }
  template <class Cycle>
  static uint32_t read(uint64_t address, Cycle cycle) {
    Bus::read_address(address, true);
    wait(cycle, [] { return Bus::read_taken(); });
    Bus::read_address(0, false);
    Bus::take_read(true);
    uint32_t value = 0;
    wait(cycle, [&] {
      value = Bus::read_data();
      return Bus::read_valid();
    });
    Bus::take_read(false);
    return value;
  }
  /// The words of a value.
  template <class Cycle>
  static void write_value(uint64_t address, const Bits& bits, unsigned width, Cycle cycle) {
    for (unsigned word = 0; word < (width + 31) / 32; ++word) write(address + 4 * word, bits[word], cycle);
  }
  template <class Cycle>
  static Bits read_value(uint64_t address, unsigned width, Cycle cycle) {
    Bits bits = zero_bits(width);
    for (unsigned word = 0; word < (width + 31) / 32; ++word) bits[word] = read(address + 4 * word, cycle);
    return bits;
  }

 private:
  template <class Cycle, class Condition>
  static void wait(Cycle cycle, Condition condition) {
    bool happened = false;
    for (unsigned tries = 0; !happened; ++tries) {
      cycle([&] { happened = condition(); });
      if (tries == 100000) {
        std::fprintf(stderr, "error: the design does not answer on AXI4-Lite\n");
        std::exit(3);
      }
    }
  }
};

/// Cycle counts over all calls, told at exit on standard error.
class Statistics {
 public:
  /// `schedule`: the latency that the schedule tells; empty: none.
  Statistics(const char* top, const char* schedule) : top_(top), schedule_(schedule) {}
  ~Statistics() {
    if (calls_ == 0) return;
    std::fprintf(stderr, "cosim %s: %llu calls, latency %llu to %llu cycles, mean %.1f%s%s\n", top_,
                 (unsigned long long)calls_, (unsigned long long)least_, (unsigned long long)most_,
                 double(total_) / calls_, *schedule_ ? "; by schedule " : "", schedule_);
  }
  void call(uint64_t cycles) {
    least_ = calls_ && least_ < cycles ? least_ : cycles;
    most_ = most_ > cycles ? most_ : cycles;
    total_ += cycles;
    ++calls_;
  }

 private:
  const char *top_, *schedule_;
  uint64_t calls_ = 0, least_ = 0, most_ = 0, total_ = 0;
};

/// Cycles without any transfer after which the design counts as dead; HLSC_TIMEOUT overrides. A run that
/// looks for FIFO depths (HLSC_DEPTHS) grows them soon: too early costs only depth.
inline uint64_t idle_limit() {
  static const uint64_t limit = std::getenv("HLSC_TIMEOUT")
                                    ? std::strtoull(std::getenv("HLSC_TIMEOUT"), nullptr, 0)
                                : std::getenv("HLSC_DEPTHS") ? 5000
                                                             : 1000000;
  return limit;
}

}  // namespace hlsc_cosim

#endif
