#include "design/fold.h"

#include <algorithm>

namespace hlsc {
namespace {

/// Whether `mask` has ones in all bits of the result in which `value` may have them.
bool passes_all(const Operation& result, const Operation& value, const Operation& mask) {
  if (mask.kind != OpKind::kConstant || value.kind == OpKind::kConstant) return false;
  unsigned live = value.is_signed ? result.bits : std::min(result.bits, value.bits);
  llvm::APInt bits = mask.is_signed ? mask.constant.sextOrTrunc(live) : mask.constant.zextOrTrunc(live);
  return bits.isAllOnes();
}

/// Whether a comparison of a single bit with a constant is that bit.
bool is_the_bit(const Operation& comparison, const Operation& value, const Operation& constant) {
  if (value.kind == OpKind::kConstant || value.bits != 1 || value.is_signed) return false;
  if (constant.kind != OpKind::kConstant) return false;
  return (comparison.compare == CompareKind::kNe && constant.constant.isZero()) ||
         (comparison.compare == CompareKind::kEq && constant.constant.isOne());
}

/// The operand that `op` passes on, or -1.
int passed_on(const Process& process, const Operation& op) {
  for (int kept : {0, 1}) {
    const Operation &value = process[op.operands[kept]], &other = process[op.operands[1 - kept]];
    if (op.kind == OpKind::kAnd ? passes_all(op, value, other) : is_the_bit(op, value, other)) return kept;
  }
  return -1;
}

}  // namespace

void fold(Process& process) {
  for (Operation& op : process.operations) {
    if (op.kind != OpKind::kAnd && op.kind != OpKind::kCompare) continue;
    int kept = passed_on(process, op);
    if (kept < 0) continue;
    op.kind = OpKind::kTrunc;
    op.operands = {op.operands[kept]};
  }
}

}  // namespace hlsc
