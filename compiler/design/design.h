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

#include <map>
#include <set>
#include <string>
#include <vector>

#include "frontend/diagnostic.h"
#include "frontend/directive.h"

namespace hlsc {

using ValueId = int;
constexpr ValueId kNoValue = -1;

enum class OpKind {
  kConstant,
  kInput,  ///< A scalar port, stable while the process runs; in a loop of calls taken when one begins.
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
  kConcat,  ///< operands: lowest first, each as wide as its type
  kLoad,    ///< operands: address
  kStore,   ///< operands: address, data
  kRead,    ///< of a stream
  kWrite,   ///< operands: data
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
  unsigned operand_width = 0;  ///< Of a comparison or an extension: the type width of its operands.
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

/// What one of the ports of a memory outside does: number k has the signals NAME_address<k>, NAME_ce<k> ...
struct MemoryPort {
  bool reads = false, writes = false;
};

/// DEPENDENCE: what accesses of an array in a loop do not have to do with each other.
struct DependenceClaim {
  int number = -1;            ///< One of the claims of the loops where it holds; -1: it holds in all.
  bool in_iteration = false;  ///< It speaks of accesses of one iteration (intra), which never meet.
  int distance =
      0;  ///< inter: accesses of one word are at least so many iterations apart; 0: there are none.
  bool read_after_write = true, write_after_read = true, write_after_write = true;  ///< What it speaks of.

  bool covers(const Operation& early, const Operation& late) const {
    if (late.kind == OpKind::kLoad) return read_after_write;
    return early.kind == OpKind::kLoad ? write_after_read : write_after_write;
  }
};

struct Memory {
  std::string name;
  MemoryKind kind = MemoryKind::kRam;
  unsigned width = 0;
  bool is_signed = false;  ///< How loads extend.
  uint64_t depth = 1;
  std::vector<llvm::APInt> initial;  ///< Static or constant contents; empty: undefined at start.
  std::vector<DependenceClaim> claims;
  bool is_aggregate = false;  ///< A port whose words are whole structs, first member in the lowest bits.
  bool is_copied = false;     ///< It has a copy, or is one (copy_memory.h).
  std::string aggregate;  ///< AGGREGATE on a local array of structs: name of the memory of whole elements.
  bool is_read = false, is_written = false;
  bool may_have_two_ports = false;  ///< Of a port: what lies behind it is the user's dual-port memory.
  bool has_two_ports = false;       ///< Of a port: any two accesses a cycle, in place of a read and a write.
  std::vector<MemoryPort> ports;    ///< Of a port, known when the process is scheduled.
  unsigned load_latency = 1;        ///< Cycles: 0 registers and logic, 1 RAM, more: a far_ram.
  bool is_block_table = false;      ///< Of a ROM: it lies in block RAM.
  int argument = -1;                ///< Of a port: index of the parameter.
  int llvm_argument = -1;           ///< As in Stream.
  uint64_t byte_offset = 0;         ///< Of a port: the leaf's place in an element.
  uint64_t stride = 0;              ///< Of a port: bytes from word to word in C++.
  SourceLocation location;

  /// Or may: nobody told.
  bool starts_as_zero() const { return initial.empty() || (initial.size() == 1 && initial[0].isZero()); }
};

struct Stream {
  std::string name;
  int index = -1;            ///< In an array of streams.
  uint64_t byte_offset = 0;  ///< Of the handle in the parameter's object.
  unsigned width = 0;
  bool is_input = false;   ///< Read by this process.
  bool is_lock = false;    ///< Its tokens take and give the memory port of the same parameter (guards).
  int argument = -1;       ///< Index of the parameter.
  int llvm_argument = -1;  ///< Index of the parameter in LLVM IR, where one C++ parameter may be several.
  std::string global;      ///< Name in LLVM IR of a stream that is no parameter.
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
  int llvm_argument = -1;    ///< As in Stream.
  int instance = -1;         ///< Of a region's head: the instance that takes this output.

  /// Announced by a NAME_ap_vld pulse.
  bool has_valid() const { return is_output && !is_result && instance < 0; }
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
  /// Of a loop: its iterations are the calls of the process, each of which begins when there is a start.
  bool takes_calls = false;
  int wanted_ii = 0;     ///< 0: the least possible.
  std::set<int> claims;  ///< Numbers of the claims of arrays that stand in this loop.
  SourceLocation location;

  bool has(const DependenceClaim& claim) const { return claim.number < 0 || claims.count(claim.number); }
};

/// A loop of the source that is still one, pipelined or not.
struct SourceLoop {
  std::string name;  ///< Its label in the source, else that of its first block.
  SourceLocation location;
  int header = 0;                            ///< Block.
  std::vector<int> blocks;                   ///< Those of inner loops among them.
  int parent = -1;                           ///< The loop around it.
  uint64_t least_trips = 0, most_trips = 0;  ///< Iterations of one run, as far as known; most 0: not known.
};

struct Process {
  std::string name;  ///< Module name.
  std::string source_name;
  SourceLocation location;
  std::vector<Operation> operations;
  std::vector<Block> blocks;      ///< Block 0 is the entry.
  std::vector<SourceLoop> loops;  ///< Outer ones before their inner ones.
  std::vector<Memory> memories;
  std::vector<Stream> streams;
  std::vector<ScalarPort> scalars;

  /// The loop whose iterations are the calls; -1: calls follow each other, from the entry to a return.
  int call_loop() const {
    for (size_t i = 0; i < blocks.size(); ++i)
      if (blocks[i].takes_calls) return i;
    return -1;
  }

  /// Whether a stream access takes or gives away the memory: no access of it may pass it.
  bool guards(const Operation& access, int memory) const {
    return access.is_stream_access() && streams[access.object].is_lock &&
           memories[memory].kind == MemoryKind::kPort &&
           memories[memory].llvm_argument == streams[access.object].llvm_argument;
  }

  Operation& operator[](ValueId id) { return operations[id]; }
  const Operation& operator[](ValueId id) const { return operations[id]; }
};

/// Ties a memory port of an instance to a member of a channel.
struct ChannelPort {
  std::string memory;
  int channel = 0;
  uint64_t byte_offset = 0;
  unsigned address_width = 0;  ///< Of the instance's port.
  bool reads_back = false;     ///< A writer's port that reads, too.
};

/// Ties a memory port of an instance to an array outside the top.
struct MemoryTie {
  std::string memory;   ///< The instance's port.
  std::string outside;  ///< The top's.
  int argument = -1;    ///< The top's parameter.
};

/// One call in a dataflow region: which signals of the region its ports are tied to.
struct Instance {
  int process = 0;  ///< Index in the list of processes the region was built with.
  std::string name;
  std::vector<int> streams;  ///< By the process' stream: index in Region::streams.
  /// By the process' scalar: an input's index in Region::run_scalars, an output's in Region::head.scalars;
  /// -1: Region::scalars tie it.
  std::vector<int> scalars;
  std::vector<MemoryTie> memories;
  std::vector<ChannelPort> channels;
  bool is_task = false;  ///< Starts again by itself, whatever the region's runs are.
};

/// A stream of a dataflow region: a FIFO between two instances, or a port of the top.
struct RegionStream {
  std::string name;
  unsigned width = 0;
  int depth = 2;
  int argument = -1;             ///< Parameter of the top; -1: local.
  int index = -1;                ///< In an array of streams.
  int writer = -1, reader = -1;  ///< Instances.
  int channel = -1;              ///< The channel of which it takes and gives banks; -1: a stream of its own.
  bool fills = false;            ///< With a channel: its tokens are the filled banks, else those claimed.
  SourceLocation location;       ///< Of the first call that takes it.
};

/// An array between two instances: two banks, the writer fills one while the reader takes the other. A bank
/// changes hands when a run ends, or, of hls::stream_of_blocks, by the tokens of two streams.
struct RegionChannel {
  std::string name;
  uint64_t depth = 0;                          ///< Elements.
  unsigned banks = 2;                          ///< That are filled or locked at most.
  bool has_locks = false;                      ///< Of hls::stream_of_blocks.
  int writer = -1, reader = -1;                ///< Instances; no reader: what is written goes nowhere.
  std::map<uint64_t, unsigned> member_widths;  ///< Byte offset of a member in an element -> bits.
  std::set<uint64_t> read_back;                ///< Members that the writer reads, too, by their byte offset.
  SourceLocation location;                     ///< Of the first call that takes it.
};

/// A scalar that one instance sets for another: it passes on when the writer's run ends.
struct RegionScalar {
  std::string name;
  unsigned width = 0;
  bool is_signed = false;
  int writer = -1, reader = -1;  ///< Instances.
  int output = -1, input = -1;   ///< Scalar ports of their processes.
};

/// A dataflow region. `head` computes at the start of a run the scalars that the instances take (its outputs
/// with `instance` >= 0); a FIFO of starts before each instance lets runs overlap. Where the calls stand in a
/// loop, each iteration is a run: the head is the loop, and writes the run's scalars to its only stream.
struct Region {
  Process head;
  bool is_loop = false;
  std::vector<ScalarPort> run_scalars;  ///< In the order in which a loop's head joins them, lowest first.
  std::vector<Instance> instances;
  std::vector<RegionStream> streams;
  std::vector<RegionChannel> channels;
  std::vector<RegionScalar> scalars;
};

/// Bits that address `depth` words, at least 1.
inline unsigned address_bits(uint64_t depth) {
  unsigned bits = 1;
  while ((uint64_t{1} << bits) < depth) ++bits;
  return bits;
}

}  // namespace hlsc

#endif
