#include "verilog/process_emitter.h"
#include "verilog/text.h"

namespace hlsc {

std::string ProcessEmitter::signal(ValueId id, Place at) {
  const Operation& op = process_[id];
  if (op.kind == OpKind::kInput) return process_.scalars[op.object].name;
  if (op.block != at.block) return held(id);
  int ready = schedule_.ready[id];
  if (is_loop(at.block)) {
    if (at.cycle <= ready) return op.name;
    int& last = last_stage_[id];
    last = std::max(last, at.cycle);
    return op.name + "_s" + std::to_string(at.cycle);
  }
  if (op.kind == OpKind::kPhi || at.cycle <= ready) return op.name;
  return held(id);
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

void ProcessEmitter::emit_stages() {
  std::map<std::string, std::ostringstream> by_enable;
  std::vector<std::string> order;
  for (auto [id, last] : last_stage_) {
    const Operation& op = process_[id];
    int ready = schedule_.ready[id];
    for (int cycle = ready + 1; cycle <= last; ++cycle) {
      std::string ce = enable({op.block, cycle - 1});
      if (!by_enable.count(ce)) order.push_back(ce);
      std::string from = cycle - 1 == ready ? op.name : op.name + "_s" + std::to_string(cycle - 1);
      std::string to = op.name + "_s" + std::to_string(cycle);
      registers_ << "    reg " << range_text_spaced(op.bits) << to << ";\n";
      by_enable[ce] << "            " << to << " <= " << from << ";\n";
    }
  }
  for (const std::string& ce : order)
    data_ << "        if (" << ce << ") begin\n" << by_enable[ce].str() << "        end\n";
}

}  // namespace hlsc
