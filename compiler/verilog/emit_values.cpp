#include "verilog/process_emitter.h"
#include "verilog/text.h"

namespace hlsc {

std::string ProcessEmitter::signal(ValueId id, Place at) {
  const Operation& op = process_[id];
  if (op.kind == OpKind::kInput && op.block < 0) return process_.scalars[op.object].name;
  if (op.block != at.block) return held(id);
  if (is_loop(at.block)) {
    int copy = copy_of(id, at.cycle);
    if (copy == 0) return own_name(id);
    int& copies = copies_[id];
    copies = std::max(copies, copy);
    return copy_name(id, copy);
  }
  if (op.kind == OpKind::kPhi || at.cycle <= schedule_.ready[id]) return op.name;
  return held(id);
}

const std::string& ProcessEmitter::own_name(ValueId id) const {
  auto shared = shared_phis_.find(id);
  return process_[shared == shared_phis_.end() ? id : shared->second].name;
}

/// A phi keeps its value until it takes that of the next iteration.
int ProcessEmitter::last_cycle(ValueId id) const {
  const Operation& op = process_[id];
  int ready = schedule_.ready[id];
  if (op.kind != OpKind::kPhi) return ready;
  return std::min(ready + timing(op.block).ii, timing(op.block).length) - 1;
}

int ProcessEmitter::copy_of(ValueId id, int cycle) const {
  int ii = timing(process_[id].block).ii, late = cycle - last_cycle(id);
  return late <= 0 ? 0 : (late + ii - 1) / ii;
}

ValueId ProcessEmitter::phi_with(ValueId id, int copy) const {
  const Operation& op = process_[id];
  const Block& loop = block_of(op.block);
  int ii = timing(op.block).ii, taken = last_cycle(id) + (copy - 1) * ii;
  for (ValueId candidate : loop.operations) {
    const Operation& phi = process_[candidate];
    if (phi.kind != OpKind::kPhi) break;
    for (size_t k = 0; k < phi.operands.size(); ++k)
      if (loop.predecessors[k] == op.block && phi.operands[k] == id && candidate != id &&
          phi.bits == op.bits && last_cycle(candidate) == taken)
        return candidate;
  }
  return kNoValue;
}

std::string ProcessEmitter::copy_name(ValueId id, int copy) const {
  const Operation& op = process_[id];
  if (copy == 0) return own_name(id);
  if (ValueId phi = phi_with(id, copy); phi != kNoValue) return own_name(phi);
  int first = last_cycle(id) + (copy - 1) * timing(op.block).ii + 1;
  return op.name + "_s" + std::to_string(first);
}

std::string ProcessEmitter::held(ValueId id) {
  const Operation& op = process_[id];
  if (op.kind == OpKind::kPhi && !is_loop(op.block)) return op.name;
  held_.insert(id);
  return op.name + "_q";
}

std::string ProcessEmitter::text(ValueId id, unsigned width, Place at) {
  const Operation& op = process_[id];
  if (op.kind == OpKind::kConstant) {
    llvm::APInt value = op.is_signed ? op.constant.sextOrTrunc(width) : op.constant.zextOrTrunc(width);
    return literal_text(value, width);
  }
  return resized_text(signal(id, at), op.bits, op.is_signed, width);
}

std::string ProcessEmitter::range_text_spaced(unsigned width) {
  return width == 1 ? "" : range_text(width).substr(1) + " ";
}

void ProcessEmitter::emit_held_values() {
  for (ValueId id : held_) {
    const Operation& op = process_[id];
    Place at{op.block, schedule_.ready[id]};
    if (is_loop(op.block)) {
      const Block& loop = block_of(op.block);
      if (loop.terminator.condition != kNoValue && process_[loop.terminator.condition].block == op.block)
        at.cycle = std::max(at.cycle, schedule_.ready[loop.terminator.condition]);
    }
    registers_ << "    reg " << range_text_spaced(op.bits) << op.name << "_q;\n";
    data_ << "        if (" << happens(at) << ") " << op.name << "_q <= " << signal(id, at) << ";\n";
  }
}

/// Every copy is taken when the one before is about to change: each cycle in a loop with II = 1, else once an
/// iteration. A phi that takes the value then is that copy.
void ProcessEmitter::emit_copies() {
  std::map<std::string, std::ostringstream> by_enable;
  std::vector<std::string> order;
  for (auto [id, copies] : copies_) {
    const Operation& op = process_[id];
    int ii = timing(op.block).ii;
    for (int copy = 1; copy <= copies; ++copy) {
      if (phi_with(id, copy) != kNoValue) continue;
      Place at{op.block, last_cycle(id) + (copy - 1) * ii};
      std::string take = ii == 1 ? enable(at) : happens(at);
      if (!by_enable.count(take)) order.push_back(take);
      registers_ << "    reg " << range_text_spaced(op.bits) << copy_name(id, copy) << ";\n";
      by_enable[take] << "            " << copy_name(id, copy) << " <= " << copy_name(id, copy - 1) << ";\n";
    }
  }
  for (const std::string& take : order)
    data_ << "        if (" << take << ") begin\n" << by_enable[take].str() << "        end\n";
}

}  // namespace hlsc
