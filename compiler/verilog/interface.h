/// The ports of a generated top, as an adapter, a wrapper or a report needs to know them.
#ifndef HLSC_VERILOG_INTERFACE_H
#define HLSC_VERILOG_INTERFACE_H

#include <string>
#include <vector>

#include "design/design.h"
#include "frontend/type_layout.h"

namespace hlsc {

/// Bits [low, low + width) of a stream's element on a signal of its own.
struct InterfaceField {
  std::string signal;
  unsigned low = 0, width = 0;
};

struct InterfaceStream {
  std::string name;
  std::string valid, ready;  ///< Handshake signals, both high-active.
  std::vector<InterfaceField> fields;
  unsigned width = 0;
  bool is_input = false;
  int argument = -1;
  int index = -1;  ///< Of an array of streams; -1: no array.
};

/// Signals of one port of an array outside: word addresses, the answer to a read comes a cycle later. A word
/// is written when `enable` and `write_enable` are up.
struct InterfaceMemoryPort {
  std::string address, enable;
  std::string read_data;                 ///< Empty: it does not read.
  std::string write_enable, write_data;  ///< Empty: it does not write.
};

/// An array outside.
struct InterfaceMemory {
  std::string name;
  std::vector<InterfaceMemoryPort> ports;
  unsigned width = 0;
  uint64_t depth = 0, stride = 0;  ///< Words; bytes from element to element in C++.
  bool is_read = false, is_written = false;
  int argument = -1;
  std::vector<Leaf> leaves;  ///< Of an element, in the word's bits from the lowest.

  /// The port of an array with at most one that reads, which it has.
  const InterfaceMemoryPort& reader() const { return ports.front(); }
  /// The same for writing.
  const InterfaceMemoryPort& writer() const { return ports.back(); }
};

/// A scalar argument, or the return value, in a bank of registers.
struct AxiliteRegister {
  ScalarPort port;
  unsigned offset = 0;            ///< Bytes.
  unsigned valid_offset() const;  ///< Of the word behind the value, where an output tells that it is set.
};

/// An array argument in a bank: its elements follow each other, each in a power of two of bytes.
struct AxiliteArray {
  InterfaceMemory memory;
  uint64_t offset = 0;
  unsigned element_bytes() const;
  unsigned row_bytes() const;         ///< Of a row of its RAMs: an element, or a word of the bus.
  uint64_t span() const;              ///< Bytes of address space, a power of two.
  unsigned row_address_bits() const;  ///< Of a row.
};

/// Arguments behind one AXI4-Lite port.
struct AxiliteBank {
  std::string name;
  unsigned address_width = 0;
  bool has_control = false;   ///< The handshake of the top and the interrupt are in this bank.
  bool has_continue = false;  ///< ap_continue among them.
  std::vector<AxiliteRegister> registers;
  std::vector<AxiliteArray> arrays;
};

struct TopInterface {
  std::string module, clock, reset;
  bool reset_is_low = false;
  bool has_start = true;      ///< ap_start, ap_done, ap_idle, ap_ready.
  bool has_continue = false;  ///< ap_continue.
  bool tells_runs = false;    ///< Without ap_start and streams: a probe tells the end of each run.
  std::vector<InterfaceStream> streams;
  std::vector<InterfaceMemory> memories;
  std::vector<ScalarPort> scalars;
  std::vector<AxiliteBank> banks;  ///< What is in one has no signals of its own outside.

  /// The bank that starts the top; null when ap_start is a signal.
  const AxiliteBank* control_bank() const {
    for (const AxiliteBank& bank : banks)
      if (bank.has_control) return &bank;
    return nullptr;
  }
};

}  // namespace hlsc

#endif
