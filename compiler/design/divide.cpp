#include "design/divide.h"

#include <algorithm>
#include <map>

namespace hlsc {
namespace {

class DivisionExpander {
 public:
  explicit DivisionExpander(Process& process) : process_(process) {}

  void run() {
    for (size_t index = 0; index < process_.blocks.size(); ++index) {
      std::vector<ValueId> old;
      old.swap(process_.blocks[index].operations);
      for (ValueId id : old) {
        if (is_division(process_[id].kind))
          expand(id, index);
        else
          process_.blocks[index].operations.push_back(id);
      }
    }
    forward_results();
  }

 private:
  static bool is_division(OpKind kind) {
    return kind == OpKind::kUDiv || kind == OpKind::kSDiv || kind == OpKind::kURem || kind == OpKind::kSRem;
  }

  void expand(ValueId id, int block) {
    block_ = block;
    source_ = process_[id];
    bool is_signed = source_.kind == OpKind::kSDiv || source_.kind == OpKind::kSRem;
    bool wants_quotient = source_.kind == OpKind::kUDiv || source_.kind == OpKind::kSDiv;
    ValueId dividend = source_.operands[0], divisor = source_.operands[1];
    ValueId dividend_negative = kNoValue, divisor_negative = kNoValue;
    if (is_signed) {
      dividend = magnitude(dividend, dividend_negative);
      divisor = magnitude(divisor, divisor_negative);
    }
    auto [quotient, remainder] = divided(dividend, divisor);
    ValueId result = resized(wants_quotient ? quotient : remainder, source_.type_width);
    ValueId negative = dividend_negative;
    if (wants_quotient) negative = exclusive(dividend_negative, divisor_negative);
    if (negative != kNoValue)
      result = select(negative, binary(OpKind::kSub, constant(source_.type_width, 0), result), result);
    results_[id] = result;
  }

  /// |value|; `negative` becomes the condition under which the sign was changed, kNoValue when it never is.
  ValueId magnitude(ValueId value, ValueId& negative) {
    const Operation op = process_[value];
    bool may_be_negative = op.is_signed || op.bits == op.type_width;
    if (!may_be_negative) return value;
    if (op.kind == OpKind::kConstant) {
      llvm::APInt number = op.constant;
      if (number.isNegative()) negative = constant(1, 1);
      return constant_of(number.abs());
    }
    negative = compare(CompareKind::kSLt, value, constant(op.type_width, 0));
    ValueId absolute = select(negative, binary(OpKind::kSub, constant(op.type_width, 0), value), value);
    process_[absolute].bits = op.is_signed ? std::min(op.bits, op.type_width) : op.type_width;
    return absolute;
  }

  ValueId exclusive(ValueId a, ValueId b) {
    if (a == kNoValue || b == kNoValue) return a == kNoValue ? b : a;
    return binary(OpKind::kXor, a, b);
  }

  std::pair<ValueId, ValueId> divided(ValueId dividend, ValueId divisor) {
    const Operation& by = process_[divisor];
    if (by.kind == OpKind::kConstant && !by.constant.isZero())
      return divided_by_constant(dividend, by.constant);
    return restoring(dividend, divisor);
  }

  std::pair<ValueId, ValueId> divided_by_constant(ValueId dividend, llvm::APInt divisor) {
    unsigned width = source_.type_width;
    unsigned n = process_[dividend].is_signed ? width : process_[dividend].bits;
    unsigned l = divisor.ceilLogBase2();
    unsigned wide = 2 * n + l + 2;
    llvm::APInt reciprocal = llvm::APInt::getOneBitSet(std::max(wide, divisor.getBitWidth() + 1), n + l);
    llvm::APInt d = divisor.zext(reciprocal.getBitWidth());
    reciprocal = (reciprocal + d - 1).udiv(d).zextOrTrunc(wide);
    ValueId product = binary(OpKind::kMul, resized(dividend, wide), constant_of(reciprocal));
    ValueId quotient = resized(binary(OpKind::kLShr, product, constant(wide, n + l)), width);
    ValueId back = binary(OpKind::kMul, quotient, constant_of(divisor.zextOrTrunc(width)));
    return {quotient, binary(OpKind::kSub, dividend_as(dividend, width), back)};
  }
  ValueId dividend_as(ValueId dividend, unsigned width) { return resized(dividend, width); }

  /// One quotient bit a step, from the top: the remainder takes in a bit of the dividend and gives the
  /// divisor away when it can.
  std::pair<ValueId, ValueId> restoring(ValueId dividend, ValueId divisor) {
    unsigned width = source_.type_width;
    unsigned steps = process_[dividend].is_signed ? width : process_[dividend].bits;
    unsigned divisor_bits = process_[divisor].is_signed ? width : process_[divisor].bits;
    unsigned inner = divisor_bits + 1;
    ValueId by = resized(divisor, inner);
    ValueId remainder = constant(inner, 0), quotient = constant(width, 0);
    for (unsigned step = steps; step-- > 0;) {
      ValueId bit = resized(
          resized(step ? binary(OpKind::kLShr, dividend, constant(width, step)) : dividend, 1), inner);
      ValueId grown = binary(OpKind::kOr, binary(OpKind::kShl, remainder, constant(inner, 1)), bit);
      ValueId fits = compare(CompareKind::kUGe, grown, by);
      remainder = select(fits, binary(OpKind::kSub, grown, by), grown);
      ValueId placed = resized(fits, width);
      if (step) placed = binary(OpKind::kShl, placed, constant(width, step));
      quotient = binary(OpKind::kOr, quotient, placed);
    }
    return {quotient, resized(remainder, width)};
  }

  // --- Operations ---

  ValueId constant(unsigned width, uint64_t value) { return constant_of(llvm::APInt(width, value)); }
  ValueId constant_of(const llvm::APInt& value) {
    Operation op;
    op.kind = OpKind::kConstant;
    op.type_width = value.getBitWidth();
    op.bits = std::max(1u, value.getActiveBits());
    op.constant = value;
    process_.operations.push_back(op);
    return process_.operations.size() - 1;
  }
  ValueId add(OpKind kind, unsigned width, std::vector<ValueId> operands, const char* role) {
    Operation op;
    op.kind = kind;
    op.type_width = op.bits = width;
    op.operands = std::move(operands);
    op.block = block_;
    op.location = source_.location;
    op.name = source_.name + "_" + role + std::to_string(count_++);
    process_.operations.push_back(op);
    process_.blocks[block_].operations.push_back(process_.operations.size() - 1);
    return process_.operations.size() - 1;
  }
  ValueId binary(OpKind kind, ValueId a, ValueId b) {
    return add(kind, process_[a].type_width, {a, b}, "step");
  }
  ValueId select(ValueId condition, ValueId yes, ValueId no) {
    return add(OpKind::kSelect, process_[yes].type_width, {condition, yes, no}, "kept");
  }
  ValueId compare(CompareKind kind, ValueId a, ValueId b) {
    ValueId id = add(OpKind::kCompare, 1, {a, b}, "fits");
    process_[id].compare = kind;
    process_[id].operand_width = process_[a].type_width;
    return id;
  }
  ValueId resized(ValueId value, unsigned width) {
    unsigned from = process_[value].type_width;
    if (from == width) return value;
    if (process_[value].kind == OpKind::kConstant)
      return constant_of(process_[value].constant.zextOrTrunc(width));
    return add(from > width ? OpKind::kTrunc : OpKind::kZExt, width, {value}, "part");
  }

  void forward_results() {
    auto forwarded = [&](ValueId id) {
      auto found = results_.find(id);
      return found == results_.end() ? id : found->second;
    };
    for (Operation& op : process_.operations) {
      for (ValueId& operand : op.operands) operand = forwarded(operand);
      op.predicate = forwarded(op.predicate);
    }
    for (Block& block : process_.blocks) block.terminator.condition = forwarded(block.terminator.condition);
  }

  Process& process_;
  Operation source_;
  int block_ = 0;
  int count_ = 0;
  std::map<ValueId, ValueId> results_;
};

}  // namespace

void expand_divisions(Process& process) { DivisionExpander(process).run(); }

}  // namespace hlsc
