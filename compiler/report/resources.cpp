#include "report/resources.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "design/shared_phis.h"

namespace hlsc {
namespace {

constexpr uint64_t kLutRamBits = 1024;       ///< Larger memories go to block RAM.
constexpr unsigned kLutMultiplierBits = 10;  ///< Products of smaller operands are built of LUTs.
constexpr uint64_t kBlockRamBits = 18 * 1024;

int rounded(double number) { return static_cast<int>(std::ceil(number)); }
int blocks_of(uint64_t amount, uint64_t block) { return static_cast<int>((amount + block - 1) / block); }

class Estimate {
 public:
  Estimate(const Process& process, const ProcessSchedule& schedule, const Target& target)
      : process_(process), schedule_(schedule), target_(target) {}

  Resources run() {
    for (const Block& block : process_.blocks)
      for (ValueId id : block.operations) operation(id);
    for (const Memory& memory : process_.memories) this->memory(memory);
    for (const ScalarPort& port : process_.scalars)
      if (port.is_output) total_.ff += port.width;
    registers();
    control();
    return total_;
  }

 private:
  bool is_constant(ValueId id) const { return process_[id].kind == OpKind::kConstant; }

  void operation(ValueId id) {
    const Operation& op = process_[id];
    switch (op.kind) {
      case OpKind::kAdd:
      case OpKind::kSub:
        total_.lut += op.bits;
        break;
      case OpKind::kMul:
        multiplier(op);
        break;
      case OpKind::kAnd:
      case OpKind::kOr:
      case OpKind::kXor:
        total_.lut += rounded(op.bits / 2.0);  // Half of them share a LUT with a neighbour.
        break;
      case OpKind::kSelect:
        total_.lut += rounded(op.bits / 2.0);
        break;
      case OpKind::kCompare:
        total_.lut += rounded(std::max(bits(op, 0), bits(op, 1)) / 2.0);
        break;
      case OpKind::kShl:
      case OpKind::kLShr:
      case OpKind::kAShr:
        if (!is_constant(op.operands[1])) total_.lut += rounded(op.bits * std::log2(op.bits + 1.0) / 2);
        break;
      default:
        break;
    }
  }

  unsigned bits(const Operation& op, size_t operand) const { return process_[op.operands[operand]].bits; }

  void multiplier(const Operation& op) {
    unsigned wide = std::max(bits(op, 0), bits(op, 1)), narrow = std::min(bits(op, 0), bits(op, 1));
    if (narrow < kLutMultiplierBits)
      total_.lut += wide * narrow;
    else
      total_.dsp += blocks_of(wide, target_.multiplier_wide) * blocks_of(narrow, target_.multiplier_narrow);
  }

  void memory(const Memory& memory) {
    uint64_t size = memory.depth * memory.width;
    if (!memory.is_read && !memory.is_written) return;
    if (memory.kind == MemoryKind::kPort) return;
    if (memory.kind == MemoryKind::kRegisters) {
      total_.ff += size;
      if (memory.depth > 1) total_.lut += rounded(size / 3.0);  // The multiplexer of a read.
    } else if (memory.kind == MemoryKind::kRom && memory.load_latency == 0) {
      total_.lut += blocks_of(memory.depth, 64) * memory.width;
    } else if (size <= kLutRamBits) {
      total_.lut += blocks_of(memory.depth, 64) * memory.width;
      total_.ff += memory.width;
    } else {
      total_.bram += std::max(blocks_of(size, kBlockRamBits), blocks_of(memory.width, 36));
    }
  }

  /// Values that are used after the cycle in which they are there.
  void registers() {
    std::vector<int> last(process_.operations.size(), -1);
    std::set<ValueId> held;
    const std::map<ValueId, ValueId> shared = shared_phis(process_);
    auto use = [&](ValueId value, int block, int cycle) {
      if (value == kNoValue || is_constant(value) || process_[value].block < 0) return;
      if (process_[value].block == block)
        last[value] = std::max(last[value], cycle);
      else
        held.insert(value);
    };
    for (size_t b = 0; b < process_.blocks.size(); ++b) {
      for (ValueId id : process_.blocks[b].operations) {
        const Operation& op = process_[id];
        if (op.kind == OpKind::kPhi && !shared.count(id)) total_.ff += op.bits;
        for (ValueId operand : op.operands)
          if (op.kind != OpKind::kPhi || process_[operand].block != static_cast<int>(b))
            use(operand, b, schedule_.start[id]);
        use(op.predicate, b, schedule_.start[id]);
      }
      use(process_.blocks[b].terminator.condition, b, schedule_.blocks[b].length - 1);
    }
    for (size_t id = 0; id < last.size(); ++id) {
      int cycles = last[id] - schedule_.ready[id];
      bool is_staged = process_[id].block >= 0 && process_.blocks[process_[id].block].is_loop;
      if (cycles > 0) total_.ff += process_[id].bits * (is_staged ? cycles : 1);
    }
    for (ValueId id : held) total_.ff += process_[id].bits;
  }

  /// The states, and the stages of each pipeline.
  void control() {
    int states = 2;
    for (size_t b = 0; b < process_.blocks.size(); ++b) {
      bool is_loop = process_.blocks[b].is_loop;
      states += is_loop ? 1 : schedule_.blocks[b].length;
      if (is_loop && schedule_.blocks[b].length > 1) total_.ff += schedule_.blocks[b].length;
    }
    total_.ff += address_bits(states);
    total_.lut += states;
  }

  const Process& process_;
  const ProcessSchedule& schedule_;
  const Target& target_;
  Resources total_;
};

}  // namespace

Resources& Resources::operator+=(const Resources& other) {
  lut += other.lut;
  ff += other.ff;
  dsp += other.dsp;
  bram += other.bram;
  return *this;
}

Resources estimate(const Process& process, const ProcessSchedule& schedule, const Target& target) {
  return Estimate(process, schedule, target).run();
}

}  // namespace hlsc
