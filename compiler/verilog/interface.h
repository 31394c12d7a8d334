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

/// An array outside: word addresses, the answer to a read comes a cycle later.
struct InterfaceMemory {
  std::string name;
  std::string read_address, read_enable, read_data;
  std::string write_address, write_enable, write_data;
  unsigned width = 0;
  uint64_t depth = 0, stride = 0;  ///< Words; bytes from element to element in C++.
  bool is_read = false, is_written = false;
  int argument = -1;
  std::vector<Leaf> leaves;  ///< Of an element, in the word's bits from the lowest.
};

struct TopInterface {
  std::string module, clock, reset;
  bool reset_is_low = false;
  bool has_start = true;      ///< ap_start, ap_done, ap_idle, ap_ready.
  bool has_continue = false;  ///< ap_continue.
  std::vector<InterfaceStream> streams;
  std::vector<InterfaceMemory> memories;
  std::vector<ScalarPort> scalars;
};

}  // namespace hlsc

#endif
