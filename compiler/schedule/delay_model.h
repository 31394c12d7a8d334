/// Operator delays by target family: the only place that knows nanoseconds.
#ifndef HLSC_SCHEDULE_DELAY_MODEL_H
#define HLSC_SCHEDULE_DELAY_MODEL_H

#include <string>

#include "design/design.h"

namespace hlsc {

/// A target family: delays of a LUT with its routing, of a carry bit, of a multiplier block and of memory.
struct Target {
  std::string name;
  double logic;       ///< One LUT level and routing, ns.
  double equality;    ///< Two values of 4 to 12 bits compared for equality, with routing, ns.
  double carry_base;  ///< An adder without its carry chain, ns.
  double carry_bit;   ///< Per bit of the carry chain, ns.
  double multiply;    ///< One multiplier block, ns.
  double memory;      ///< Clock to output of a block RAM with routing, ns.
  double registers;   ///< Clock to output of a register with routing, ns.
  double launch;      ///< Clock to operands from registers, with routing, ns; 0: the margin has it.
  double stall;       ///< From a predicate through the stall logic to a clock enable, ns.
  double enable;      ///< From a condition to the enables of registers or of a RAM that it decides, ns; 0: as
                      ///< launch.
  unsigned multiplier_wide, multiplier_narrow;  ///< Signed operand widths of a multiplier block.
  bool adds_products;      ///< A multiplier block also adds another's product; else wide products are split.
  unsigned block_words;    ///< A RAM of more words is a far_ram (rtl/lib); 0: none is.
  unsigned table_bits;     ///< A table of so many bits lies in block RAM; below, logic is less or nearer.
  int least_fifo;          ///< Words of the smallest FIFO; that of one word lets m_ready through to s_ready.
  double reach;            ///< From logic to the registers before the blocks of a far_ram, ns.
  unsigned lut_ram_words;  ///< A RAM of up to so many words lies in LUTs, as scripts/synth/flow.py has it; 0:
                           ///< each is taken for a block RAM.
};

/// xc6v (Virtex-6), xc7 (7-series) or ecp5; throws CompileError for another name.
const Target& target_named(const std::string& name);

/// Cycles that a read of rtl/lib/far_ram.v takes.
constexpr unsigned kFarRead = 6;

/// Whether this memory is a far_ram, as it spans several blocks in depth.
bool is_far(const Target& target, const Memory& memory);

/// Whether a RAM lies in LUTs: what is read passes multiplexers, then a register.
bool is_lut_ram(const Target& target, const Memory& memory);

/// From the address of a RAM in LUTs to its register, ns.
double lut_ram_read(const Target& target, const Memory& memory);

/// Whether a table lies in block RAM.
bool is_block_table(const Target& target, const Memory& memory);

/// Delay from the operands of `operation` to its result, ns.
double delay_of(const Target& target, const Process& process, const Operation& operation);

}  // namespace hlsc

#endif
