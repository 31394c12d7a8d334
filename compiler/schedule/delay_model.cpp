#include "schedule/delay_model.h"

#include <algorithm>
#include <cmath>

namespace hlsc {
namespace {

constexpr unsigned kShortRamWords = 64;  ///< In LUTs at any width.
constexpr unsigned kNarrowRamBits = 36;  ///< In LUTs at any depth up to Target::lut_ram_words.
constexpr double kLutRamCell = 16;       ///< Words.

const Target kTargets[] = {
    {"xc6v", 0.75, 1.125, 0.95, 0.030, 3.6, 2.1, 0.8, 0, 1.8, 0, 25, 18, true, 0, 2048, 1, 0, 0},
    {"xc7", 0.65, 0.975, 0.85, 0.025, 3.2, 2.1, 0.7, 0, 1.6, 0, 25, 18, true, 0, 2048, 1, 0, 0},
    // Speed grade 6, as nextpnr places it: a LUT is 0.24 ns and its routing 0.6 to 1.2. A carry chain is 0.9
    // ns, 0.036 a bit and the routing to it and of its carry out; the bits of chains in a row overlap, so a
    // bit counts less here and the chain more. Yosys uses no output registers of DP16KD and MULT18X18D: 5.8
    // ns and 3.9 ns without routing.
    {"ecp5", 1.05, 2.1, 2.30, 0.020, 5.2, 7.4, 1.2, 1.2, 4.4, 2.4, 18, 18, false, 16384, 4096, 2, 3.5, 256},
};

double adder(const Target& target, unsigned bits) { return target.carry_base + target.carry_bit * bits; }

double multiplier(const Target& target, unsigned a, unsigned b) {
  unsigned wide = std::max(a, b), narrow = std::min(a, b);
  unsigned blocks = ((wide + target.multiplier_wide - 1) / target.multiplier_wide) *
                    ((narrow + target.multiplier_narrow - 1) / target.multiplier_narrow);
  return target.multiply + (blocks > 1 ? std::ceil(std::log2(blocks)) * adder(target, a + b) : 0);
}

bool is_constant(const Process& process, ValueId id) { return process[id].kind == OpKind::kConstant; }

}  // namespace

const Target& target_named(const std::string& name) {
  for (const Target& target : kTargets)
    if (target.name == name) return target;
  throw CompileError("target '" + name + "' is not known; choose xc6v, xc7 or ecp5");
}

bool is_far(const Target& target, const Memory& memory) {
  return memory.kind == MemoryKind::kRam && memory.starts_as_zero() && target.block_words &&
         memory.depth > target.block_words;
}

bool is_lut_ram(const Target& target, const Memory& memory) {
  return memory.kind == MemoryKind::kRam && memory.depth <= target.lut_ram_words &&
         (memory.depth <= kShortRamWords || memory.width <= kNarrowRamBits);
}

double lut_ram_read(const Target& target, const Memory& memory) {
  return target.logic * (1 + std::max(0.0, std::ceil(std::log2(memory.depth / kLutRamCell) / 2)));
}

bool is_block_table(const Target& target, const Memory& memory) {
  return memory.kind == MemoryKind::kRom && memory.load_latency > 0 &&
         memory.depth * memory.width >= target.table_bits;
}

double delay_of(const Target& target, const Process& process, const Operation& operation) {
  auto bits = [&](size_t i) { return process[operation.operands[i]].bits; };
  switch (operation.kind) {
    case OpKind::kAdd:
    case OpKind::kSub:
      return adder(target, operation.bits);
    case OpKind::kMul:
      return multiplier(target, bits(0), bits(1));
    case OpKind::kUDiv:
    case OpKind::kSDiv:
    case OpKind::kURem:
    case OpKind::kSRem:
      return operation.type_width * (adder(target, operation.type_width) + target.logic);
    case OpKind::kAnd:
    case OpKind::kOr:
    case OpKind::kXor:
      return target.logic * 0.6;
    case OpKind::kShl:
    case OpKind::kLShr:
    case OpKind::kAShr:
      return is_constant(process, operation.operands[1])
                 ? 0
                 : target.logic * std::max(1.0, std::ceil(std::log2(operation.bits) / 2));
    case OpKind::kCompare: {
      unsigned width = std::max(bits(0), bits(1));
      bool is_equality = operation.compare == CompareKind::kEq || operation.compare == CompareKind::kNe;
      if (is_equality && width <= 12) return width <= 3 ? target.logic : target.equality;
      return width <= 3 ? target.logic : adder(target, width);
    }
    case OpKind::kSelect:
      return target.logic * 0.8;
    case OpKind::kLoad: {
      double levels = std::max(1.0, std::ceil(std::log2(process.memories[operation.object].depth + 1.0) / 2));
      return is_constant(process, operation.operands[0]) ? 0 : target.logic * levels;
    }
    default:
      return 0;
  }
}

}  // namespace hlsc
