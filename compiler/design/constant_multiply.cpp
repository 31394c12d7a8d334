#include "design/constant_multiply.h"

#include <algorithm>
#include <optional>

namespace hlsc {
namespace {

/// 2^first + 2^second, or 2^first - 2^second.
struct TwoDigits {
  unsigned first = 0, second = 0;
  bool subtracts = false;
};

std::optional<TwoDigits> two_digits(const llvm::APInt& number) {
  if (number.isZero()) return {};
  unsigned low = number.countr_zero();
  if (number.popcount() == 2) return TwoDigits{number.getActiveBits() - 1, low, false};
  llvm::APInt ones = number + llvm::APInt::getOneBitSet(number.getBitWidth(), low);
  if (ones.isPowerOf2()) return TwoDigits{ones.logBase2(), low, true};
  llvm::APInt negated = llvm::APInt::getOneBitSet(number.getBitWidth(), low) - number;
  if (negated.isPowerOf2()) return TwoDigits{low, negated.logBase2(), true};
  return {};
}

class Expander {
 public:
  explicit Expander(Process& process) : process_(process) {}

  void run() {
    for (Block& block : process_.blocks) {
      std::vector<ValueId> old;
      old.swap(block.operations);
      for (ValueId id : old) {
        if (process_[id].kind == OpKind::kMul) expand(id, block);
        block.operations.push_back(id);
      }
    }
  }

 private:
  void expand(ValueId id, Block& block) {
    for (int side : {0, 1}) {
      const Operation& constant = process_[process_[id].operands[side]];
      ValueId value = process_[id].operands[1 - side];
      if (constant.kind != OpKind::kConstant || process_[value].kind == OpKind::kConstant) continue;
      if (constant.constant.isPowerOf2()) {
        process_[id].operands = {value, amount(id, constant.constant.logBase2())};
        process_[id].kind = OpKind::kShl;
        return;
      }
      std::optional<TwoDigits> digits = two_digits(constant.constant);
      if (!digits) continue;
      ValueId first = shifted(id, value, digits->first, block),
              second = shifted(id, value, digits->second, block);
      process_[id].kind = digits->subtracts ? OpKind::kSub : OpKind::kAdd;
      process_[id].operands = {first, second};
      return;
    }
  }

  /// The constant by which a part of `product` is shifted.
  ValueId amount(ValueId product, unsigned count) {
    Operation op;
    op.kind = OpKind::kConstant;
    op.type_width = process_[product].type_width;
    op.constant = llvm::APInt(op.type_width, count);
    op.bits = std::max(1u, op.constant.getActiveBits());
    process_.operations.push_back(op);
    return process_.operations.size() - 1;
  }

  ValueId shifted(ValueId product, ValueId value, unsigned count, Block& block) {
    if (count == 0) return value;
    Operation shift;
    shift.kind = OpKind::kShl;
    shift.type_width = shift.bits = process_[product].type_width;
    shift.operands = {value, amount(product, count)};
    shift.block = process_[product].block;
    shift.location = process_[product].location;
    shift.name = process_[product].name + "_shifted_" + std::to_string(count);
    process_.operations.push_back(shift);
    block.operations.push_back(process_.operations.size() - 1);
    return block.operations.back();
  }

  Process& process_;
};

}  // namespace

void expand_constant_products(Process& process) { Expander(process).run(); }

}  // namespace hlsc
