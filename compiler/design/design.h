/// The compiler's own form of a program: plain structs between LLVM IR and the schedule.
///
/// A Design is a set of Processes, one Verilog module each. A Process is a graph of Blocks; a pipelined loop
/// is one Block that jumps to itself. Operations are in static single assignment and refer to each other by
/// index (`ValueId`).
///
/// Widths. An operation has the `type_width` of its LLVM type and a representation: the low `bits` of the
/// value, of which the others are copies of the top one (`is_signed`) or zero. A consumer extends or cuts as
/// it needs; narrowing only changes `bits`.
#ifndef HLSC_DESIGN_DESIGN_H
#define HLSC_DESIGN_DESIGN_H

#include <llvm/ADT/APInt.h>

#include <string>
#include <vector>

#include "frontend/diagnostic.h"
#include "frontend/directive.h"

namespace hlsc {

using ValueId = int;
constexpr ValueId kNoValue = -1;

enum class OpKind {
  kConstant,
  kInput,  ///< A scalar port, stable while the process runs.
  kPhi,
  kAdd,
  kSub,
  kMul,
  kUDiv,
  kSDiv,
  kURem,
  kSRem,
  kAnd,
  kOr,
  kXor,
  kShl,
  kLShr,
  kAShr,
  kCompare,
  kSelect,
  kZExt,
  kSExt,
  kTrunc,
  kLoad,   ///< operands: address
  kStore,  ///< operands: address, data
  kRead,   ///< of a stream
  kWrite,  ///< operands: data
  kEmpty,
  kFull,
  kOutput,  ///< operands: data; sets a scalar output port
};

enum class CompareKind { kEq, kNe, kULt, kULe, kUGt, kUGe, kSLt, kSLe, kSGt, kSGe };

struct Operation {
  OpKind kind = OpKind::kConstant;
  unsigned type_width = 0;
  unsigned bits = 0;
  bool is_signed = false;
  std::vector<ValueId> operands;
  ValueId predicate = kNoValue;  ///< Effects happen only when it is 1; kNoValue: always.
  llvm::APInt constant;
  CompareKind compare = CompareKind::kEq;
  unsigned operand_width = 0;  ///< Of a comparison: the type width of what it compares.
  int object = -1;             ///< Index of the memory, stream or scalar port.
  int block = -1;
  std::string name;  ///< Unique in the process, a Verilog identifier.
  SourceLocation location;

  bool has_effect() const {
    return kind == OpKind::kStore || kind == OpKind::kWrite || kind == OpKind::kRead ||
           kind == OpKind::kOutput;
  }
  bool has_result() const {
    return kind != OpKind::kStore && kind != OpKind::kWrite && kind != OpKind::kOutput;
  }
  bool is_stream_access() const { return kind == OpKind::kRead || kind == OpKind::kWrite; }
  bool is_memory_access() const { return kind == OpKind::kLoad || kind == OpKind::kStore; }
};

enum class MemoryKind {
  kRegisters,  ///< Any number of accesses a cycle; loads are combinational.
  kRam,        ///< One read and one write a cycle; loads take a cycle.
  kRom,        ///< Constant; loads take a cycle when large.
  kPort,       ///< Outside the module (ap_memory): as kRam.
};

struct Memory {
  std::string name;
  MemoryKind kind = MemoryKind::kRam;
  unsigned width = 0;
  bool is_signed = false;  ///< How loads extend.
  uint64_t depth = 1;
  std::vector<llvm::APInt> initial;  ///< Static or constant contents; empty: undefined at start.
  bool independent = false;          ///< DEPENDENCE inter false.
  bool is_read = false, is_written = false;
  unsigned load_latency = 1;
  SourceLocation location;
};

struct Stream {
  std::string name;
  unsigned width = 0;
  bool is_input = false;  ///< Read by this process.
  int argument = -1;      ///< Index of the parameter; -1: local to a dataflow region.
};

/// A scalar port: an input, or an output set by kOutput (with a valid pulse).
struct ScalarPort {
  std::string name;
  unsigned width = 0;
  bool is_signed = false;
  bool is_output = false;
  bool is_result = false;    ///< The function's return value (ap_return).
  int argument = -1;         ///< Index of the parameter.
  uint64_t byte_offset = 0;  ///< Of the leaf in the parameter's object.
};

struct Terminator {
  enum Kind { kJump, kBranch, kSwitch, kReturn } kind = kReturn;
  ValueId condition = kNoValue;
  std::vector<int> targets;  ///< Branch: true, false. Switch: default, then one per case.
  std::vector<llvm::APInt> cases;
};

struct Block {
  std::string name;
  std::vector<ValueId> operations;  ///< In program order, phis first.
  std::vector<int> predecessors;    ///< In the order of phi operands.
  Terminator terminator;
  bool is_loop = false;  ///< Pipelined: jumps to itself.
  int wanted_ii = 0;     ///< 0: the least possible.
  SourceLocation location;
};

struct Process {
  std::string name;  ///< Module name.
  std::string source_name;
  SourceLocation location;
  std::vector<Operation> operations;
  std::vector<Block> blocks;  ///< Block 0 is the entry.
  std::vector<Memory> memories;
  std::vector<Stream> streams;
  std::vector<ScalarPort> scalars;

  Operation& operator[](ValueId id) { return operations[id]; }
  const Operation& operator[](ValueId id) const { return operations[id]; }
};

/// Bits that address `depth` words, at least 1.
inline unsigned address_bits(uint64_t depth) {
  unsigned bits = 1;
  while ((uint64_t{1} << bits) < depth) ++bits;
  return bits;
}

}  // namespace hlsc

#endif
