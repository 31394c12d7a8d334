#include "design/simplify.h"

#include <algorithm>

namespace hlsc {
namespace {

/// The value an operation passes on unchanged, or kNoValue.
ValueId source_of_copy(const Process& process, const Operation& op) {
  if (op.kind == OpKind::kPhi) {
    if (op.operands.size() != 1) return kNoValue;
    return op.operands[0];
  }
  if (op.kind == OpKind::kAnd) {  // With ones in all bits that count.
    const Operation &value = process[op.operands[0]], &mask = process[op.operands[1]];
    bool is_idle = mask.kind == OpKind::kConstant && mask.constant.countTrailingOnes() >= op.bits;
    bool same_form = value.bits == op.bits && !value.is_signed && !op.is_signed;
    return is_idle && same_form ? op.operands[0] : kNoValue;
  }
  bool is_cast = op.kind == OpKind::kZExt || op.kind == OpKind::kSExt || op.kind == OpKind::kTrunc;
  if (!is_cast) return kNoValue;
  const Operation& source = process[op.operands[0]];
  bool same_form = source.bits == op.bits && source.is_signed == op.is_signed;
  return same_form ? op.operands[0] : kNoValue;
}

}  // namespace

void forward_copies(Process& process) {
  // An extension still has to know from which width it extends.
  for (Operation& op : process.operations)
    if (op.kind == OpKind::kZExt || op.kind == OpKind::kSExt)
      op.operand_width = process[op.operands[0]].type_width;
  std::vector<ValueId> target(process.operations.size());
  for (size_t id = 0; id < target.size(); ++id) target[id] = id;
  for (size_t id = 0; id < target.size(); ++id) {
    ValueId source = source_of_copy(process, process[id]);
    if (source != kNoValue) target[id] = source;
  }
  auto resolved = [&](ValueId id) {
    while (id != kNoValue && target[id] != id) id = target[id];
    return id;
  };
  for (Operation& op : process.operations) {
    for (ValueId& operand : op.operands) operand = resolved(operand);
    op.predicate = resolved(op.predicate);
  }
  for (Block& block : process.blocks) {
    block.terminator.condition = resolved(block.terminator.condition);
    auto passes_on = [&](ValueId id) { return target[id] != id; };
    block.operations.erase(std::remove_if(block.operations.begin(), block.operations.end(), passes_on),
                           block.operations.end());
  }
}

}  // namespace hlsc
