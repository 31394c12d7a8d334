/// s_axilite: arguments of the top behind a bank of registers on AXI4-Lite, with Vitis' addresses and signal
/// names.
#ifndef HLSC_VERILOG_AXILITE_H
#define HLSC_VERILOG_AXILITE_H

#include <string>
#include <vector>

#include "verilog/interface.h"

namespace hlsc {

/// Vitis' name of the interrupt is a word that Verilator would keep for C++.
constexpr const char* kInterruptName = "/* verilator lint_off SYMRSVDWORD */\n";

/// Gives every register and array of the bank its address. Registers follow each other from 0x10 on: the
/// words of the value, then one word that is kept free or, for an output, tells that it is valid. Arrays
/// follow, each at a multiple of its size.
void place_registers(AxiliteBank& bank);

/// The module of the bank: AXI4-Lite outside, the arguments and the handshake of the top inside.
std::string emit_axilite(const std::string& top, const AxiliteBank& bank);

/// A C header with the addresses, as Vitis writes it: x<top>_hw.h.
std::string axilite_header(const std::string& top, const std::vector<AxiliteBank>& banks);

/// Name of the bank's module.
std::string axilite_module(const std::string& top, const AxiliteBank& bank);

struct BankPort {
  bool is_input = false;
  unsigned width = 1;
  std::string name;
};
/// The bus without its clock and reset: s_axi_<bank>_AWADDR and so on.
std::vector<BankPort> bus_ports(const AxiliteBank& bank);
/// What the bank and the design tell each other; `is_input` as the bank sees it.
std::vector<BankPort> inner_ports(const AxiliteBank& bank);

}  // namespace hlsc

#endif
