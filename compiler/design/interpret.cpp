#include "design/interpret.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace hlsc {
namespace {

using llvm::APInt;

constexpr long kMaxSteps = 20'000'000;

APInt resized(const APInt& value, unsigned width, bool is_signed) {
  return is_signed ? value.sextOrTrunc(width) : value.zextOrTrunc(width);
}

}  // namespace

Interpreter::Interpreter(const Process& process, const ProcessSchedule* schedule)
    : process_(process), schedule_(schedule) {
  for (const Operation& op : process.operations) values_.emplace_back(std::max(1u, op.type_width), 0);
  reset_memories();
}

void Interpreter::reset_memories() {
  for (const Memory& memory : process_.memories) {
    std::vector<APInt> words(memory.kind == MemoryKind::kPort ? 0 : memory.depth, APInt(memory.width, 0));
    for (size_t i = 0; i < words.size() && !memory.initial.empty(); ++i)
      words[i] = memory.initial[memory.initial.size() == 1 ? 0 : i].zextOrTrunc(memory.width);
    memories_.push_back(words);
  }
}

void Interpreter::run(Surroundings& around) {
  around_ = &around;
  steps_ = 0;
  int from = -1, block = 0;
  if (has_run_ && process_.call_loop() >= 0) from = block = process_.call_loop();
  has_run_ = true;
  while (block >= 0) {
    int next = run_block(block, from, around);
    from = block;
    block = next;
  }
}

int Interpreter::run_block(int block, int from, Surroundings& around) {
  const Block& b = process_.blocks[block];
  if (schedule_ && b.is_loop) {
    run_pipeline(block, from, around);
    if (b.takes_calls) return -1;
    const std::vector<int>& targets = b.terminator.targets;
    return targets[0] == block ? targets[1] : targets[0];
  }
  // Phis take their values together.
  std::vector<std::pair<ValueId, APInt>> entered;
  for (ValueId id : b.operations)
    if (process_[id].kind == OpKind::kPhi) entered.push_back({id, entering(id, from)});
  for (auto& [id, word] : entered) values_[id] = word;
  int clock = 0;
  for (ValueId id : in_order(b)) {
    bool is_later = !schedule_ || schedule_->start[id] != clock;
    if (is_later) apply_stores(around);
    if (schedule_) clock = schedule_->start[id];
    if (process_[id].kind != OpKind::kPhi) evaluate(id, around);
  }
  apply_stores(around);
  return b.takes_calls ? -1 : successor(block);
}

std::vector<ValueId> Interpreter::in_order(const Block& block) const {
  if (!schedule_) return block.operations;
  std::map<int, std::vector<ValueId>> by_cycle;
  for (ValueId id : block.operations) by_cycle[schedule_->start[id]].push_back(id);
  std::vector<ValueId> order;
  for (const auto& [cycle, operations] : by_cycle)
    order.insert(order.end(), operations.begin(), operations.end());
  return order;
}

int Interpreter::successor(int block) const {
  const Terminator& terminator = process_.blocks[block].terminator;
  switch (terminator.kind) {
    case Terminator::kReturn:
      return -1;
    case Terminator::kJump:
      return terminator.targets[0];
    case Terminator::kBranch:
      return terminator.targets[holds(terminator.condition) ? 0 : 1];
    default:
      break;
  }
  APInt choice = value(terminator.condition);
  for (size_t i = 0; i < terminator.cases.size(); ++i)
    if (choice.zextOrTrunc(terminator.cases[i].getBitWidth()) == terminator.cases[i])
      return terminator.targets[i + 1];
  return terminator.targets[0];
}

void Interpreter::run_pipeline(int block, int from, Surroundings& around) {
  const BlockSchedule& timing = schedule_->blocks[block];
  std::deque<Iteration> running;
  const bool is_call = process_.blocks[block].takes_calls;
  int last = is_call ? 0 : -1;  // The iteration that leaves, once it is known.
  if (!is_call && process_.blocks[block].terminator.kind == Terminator::kJump)
    throw std::runtime_error("the loop '" + process_.blocks[block].name + "' has no end");
  pipeline_ = block;
  for (int clock = 0; last < 0 || clock < last * timing.ii + timing.length; ++clock) {
    clock_ = clock;
    if (clock % timing.ii == 0 && (last < 0 || clock == 0)) {
      Iteration next;
      next.index = clock / timing.ii;
      next.values = values_;
      next.known.assign(values_.size(), false);
      running.push_back(std::move(next));
    }
    step(block, from, clock, last, running, around);
    apply_stores(around);
    if (is_call) continue;
    ValueId condition = process_.blocks[block].terminator.condition;
    int known = process_[condition].block == block ? schedule_->ready[condition] : 0;
    for (Iteration& iteration : running) {
      if (last >= 0 || clock != iteration.index * timing.ii + known) continue;
      iteration_ = &iteration;
      if (successor(block) != block) last = iteration.index;
    }
    while (running.size() > 1 && running.front().index * timing.ii + timing.length < clock - timing.ii)
      running.pop_front();  // The next one has taken its phis.
  }
  iteration_ = nullptr;
  pipeline_ = -1;
  for (Iteration& iteration : running)
    if (iteration.index == last) values_ = iteration.values;
}

void Interpreter::step(int block, int from, int clock, int last, std::deque<Iteration>& running,
                       Surroundings& around) {
  const BlockSchedule& timing = schedule_->blocks[block];
  for (size_t i = 0; i < running.size(); ++i) {
    Iteration& iteration = running[i];
    if (last >= 0 && iteration.index > last) continue;
    for (ValueId id : process_.blocks[block].operations) {
      if (iteration.index * timing.ii + schedule_->start[id] != clock) continue;
      iteration_ = &iteration;
      if (process_[id].kind != OpKind::kPhi) {
        evaluate(id, around);
      } else if (iteration.index == 0) {
        iteration_ = nullptr;  // The values of the call before, too.
        iteration.values[id] = entering(id, from);
      } else {
        iteration_ = &running[i - 1];
        APInt carried = entering(id, block);
        iteration.values[id] = carried;
      }
      iteration.known[id] = true;
    }
  }
}

APInt Interpreter::entering(ValueId phi, int from) const {
  const Operation& op = process_[phi];
  const std::vector<int>& predecessors = process_.blocks[op.block].predecessors;
  for (size_t k = 0; k < op.operands.size(); ++k)
    if (predecessors[k] == from) return represented(op, operand(op, k, op.type_width));
  throw std::runtime_error("'" + op.name + "' has no value for the block that leads here");
}

APInt Interpreter::value(ValueId id) const {
  const Operation& op = process_[id];
  if (op.kind == OpKind::kConstant) return op.constant;
  if (op.kind == OpKind::kInput && op.block < 0)
    return resized(around_->scalars[op.object], op.type_width, process_.scalars[op.object].is_signed);
  if (iteration_ && op.block == pipeline_) {
    bool is_there = iteration_->known[id] &&
                    clock_ >= iteration_->index * schedule_->blocks[pipeline_].ii + schedule_->ready[id];
    if (!is_there) throw std::runtime_error("'" + op.name + "' is used before the schedule has it");
    return iteration_->values[id];
  }
  return values_[id];
}

APInt Interpreter::operand(const Operation& op, size_t index, unsigned width) const {
  ValueId id = op.operands[index];
  return resized(value(id), width, process_[id].is_signed);
}

bool Interpreter::holds(ValueId predicate) const { return predicate == kNoValue || value(predicate)[0]; }

APInt Interpreter::represented(const Operation& op, const APInt& value) {
  return resized(resized(value, op.bits, false), op.type_width, op.is_signed);
}

void Interpreter::evaluate(ValueId id, Surroundings& around) {
  if (++steps_ > kMaxSteps) throw std::runtime_error("the process does not end");
  const Operation& op = process_[id];
  if (op.kind == OpKind::kStore) return store(id, around);
  if (op.kind == OpKind::kWrite) {
    if (holds(op.predicate))
      around.outputs[op.object].push_back(operand(op, 0, process_.streams[op.object].width));
    return;
  }
  if (op.kind == OpKind::kOutput) {
    if (holds(op.predicate)) around.scalars[op.object] = operand(op, 0, process_.scalars[op.object].width);
    return;
  }
  APInt made = represented(op, result(op, around));
  (iteration_ ? iteration_->values[id] : values_[id]) = made;
}

APInt Interpreter::result(const Operation& op, Surroundings& around) {
  auto extended = [&](bool is_signed) {
    unsigned from = op.operand_width ? op.operand_width : process_[op.operands[0]].type_width;
    return resized(operand(op, 0, from), op.type_width, is_signed);
  };
  switch (op.kind) {
    case OpKind::kInput:
      return resized(around.scalars[op.object], op.type_width, process_.scalars[op.object].is_signed);
    case OpKind::kSelect:
      return operand(op, holds(op.operands[0]) ? 1 : 2, op.type_width);
    case OpKind::kCompare:
      return APInt(1, compared(op));
    case OpKind::kZExt:
      return extended(false);
    case OpKind::kSExt:
      return extended(true);
    case OpKind::kTrunc:
      return operand(op, 0, op.type_width);
    case OpKind::kConcat: {
      APInt all(op.type_width, 0);
      unsigned low = 0;
      for (ValueId part : op.operands) {
        all |= value(part).zextOrTrunc(op.type_width).shl(low);
        low += process_[part].type_width;
      }
      return all;
    }
    case OpKind::kLoad:
      return loaded(op, around);
    case OpKind::kRead: {
      std::deque<APInt>& tokens = around.inputs[op.object];
      if (!holds(op.predicate)) return APInt(op.type_width, 0);
      if (tokens.empty()) throw std::runtime_error("'" + op.name + "' reads where there is no token");
      APInt token = tokens.front();
      tokens.pop_front();
      return token.zextOrTrunc(op.type_width);
    }
    case OpKind::kEmpty:
      return APInt(1, around.inputs[op.object].empty());
    case OpKind::kFull:
      return APInt(1, 0);
    default:
      return arithmetic(op);
  }
}

APInt Interpreter::arithmetic(const Operation& op) const {
  unsigned width = op.type_width;
  APInt a = operand(op, 0, width), b = operand(op, 1, width);
  bool by_zero = b.isZero();
  uint64_t amount = b.getLimitedValue(width);
  switch (op.kind) {
    case OpKind::kAdd:
      return a + b;
    case OpKind::kSub:
      return a - b;
    case OpKind::kMul:
      return a * b;
    case OpKind::kUDiv:
      return by_zero ? b : a.udiv(b);
    case OpKind::kSDiv:
      return by_zero ? b : a.sdiv(b);
    case OpKind::kURem:
      return by_zero ? b : a.urem(b);
    case OpKind::kSRem:
      return by_zero ? b : a.srem(b);
    case OpKind::kAnd:
      return a & b;
    case OpKind::kOr:
      return a | b;
    case OpKind::kXor:
      return a ^ b;
    case OpKind::kShl:
      return a.shl(amount);
    case OpKind::kLShr:
      return a.lshr(amount);
    case OpKind::kAShr:
      return a.ashr(amount);
    default:
      throw std::runtime_error("'" + op.name + "' has no meaning here");
  }
}

bool Interpreter::compared(const Operation& op) const {
  APInt a = operand(op, 0, op.operand_width), b = operand(op, 1, op.operand_width);
  switch (op.compare) {
    case CompareKind::kEq:
      return a == b;
    case CompareKind::kNe:
      return a != b;
    case CompareKind::kULt:
      return a.ult(b);
    case CompareKind::kULe:
      return a.ule(b);
    case CompareKind::kUGt:
      return a.ugt(b);
    case CompareKind::kUGe:
      return a.uge(b);
    case CompareKind::kSLt:
      return a.slt(b);
    case CompareKind::kSLe:
      return a.sle(b);
    case CompareKind::kSGt:
      return a.sgt(b);
    default:
      return a.sge(b);
  }
}

std::vector<APInt>& Interpreter::words(int memory, Surroundings& around) {
  return process_.memories[memory].kind == MemoryKind::kPort ? around.memories[memory] : memories_[memory];
}

/// A load that the program skips may have any address; nobody uses its word.
APInt Interpreter::loaded(const Operation& op, Surroundings& around) {
  const Memory& memory = process_.memories[op.object];
  const std::vector<APInt>& contents = words(op.object, around);
  uint64_t address = operand(op, 0, address_bits(memory.depth)).getZExtValue();
  APInt word = address < contents.size() ? contents[address] : APInt(memory.width, 0);
  return resized(word, op.type_width, memory.is_signed);
}

void Interpreter::store(ValueId id, Surroundings& around) {
  const Operation& op = process_[id];
  if (!holds(op.predicate)) return;
  const Memory& memory = process_.memories[op.object];
  uint64_t address = operand(op, 0, address_bits(memory.depth)).getZExtValue();
  if (address >= words(op.object, around).size())
    throw std::runtime_error("'" + op.name + "' writes beyond the end of '" + memory.name + "'");
  stores_.push_back({id, address, operand(op, 1, memory.width)});
}

void Interpreter::apply_stores(Surroundings& around) {
  for (const PendingStore& made : stores_) words(process_[made.id].object, around)[made.address] = made.word;
  stores_.clear();
}

}  // namespace hlsc
