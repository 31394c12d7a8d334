#include "design/split_products.h"

#include <algorithm>

namespace hlsc {
namespace {

class Splitter {
 public:
  Splitter(Process& process, unsigned block_bits) : process_(process), block_bits_(block_bits) {}

  void run() {
    for (Block& block : process_.blocks) {
      std::vector<ValueId> old;
      old.swap(block.operations);
      for (ValueId id : old) {
        if (process_[id].kind == OpKind::kMul) split(id, block);
        block.operations.push_back(id);
      }
    }
  }

 private:
  /// Puts what `product` is the sum of before it, in `block`, and makes it that sum.
  void split(ValueId product, Block& block) {
    int wide = factor_bits(product, 0) >= factor_bits(product, 1) ? 0 : 1;
    if (factor_bits(product, wide) <= block_bits_) return;
    ValueId factor = process_[product].operands[wide], other = process_[product].operands[1 - wide];
    unsigned width = process_[product].type_width, low_bits = block_bits_ - 1;

    ValueId cut = add(OpKind::kTrunc, low_bits, {factor}, product, "low", block);
    ValueId low = add(OpKind::kZExt, width, {cut}, product, "low_part", block);
    process_[low].operand_width = process_[low].bits = low_bits;
    OpKind shift = process_[factor].is_signed ? OpKind::kAShr : OpKind::kLShr;
    ValueId high = add(shift, width, {factor, amount(width)}, product, "high_part", block);
    process_[high].is_signed = process_[factor].is_signed;
    process_[high].bits = process_[factor].bits - low_bits;

    ValueId lower = partial(low, other, product, "low_product", block);
    ValueId upper = partial(high, other, product, "high_product", block);
    ValueId shifted = add(OpKind::kShl, width, {upper, amount(width)}, product, "high_shifted", block);
    process_[product].kind = OpKind::kAdd;
    process_[product].operands = {shifted, lower};
  }

  /// Bits of a factor as it enters the block: no more than the product has, and a zero above an unsigned
  /// one beside a signed one.
  unsigned factor_bits(ValueId product, int side) const {
    const Operation& op = process_[product];
    const Operation &factor = process_[op.operands[side]], &other = process_[op.operands[1 - side]];
    bool needs_zero = !factor.is_signed && other.is_signed;
    return std::min(factor.bits + (needs_zero ? 1 : 0), op.bits);
  }

  ValueId partial(ValueId part, ValueId other, ValueId product, const char* role, Block& block) {
    ValueId id = add(OpKind::kMul, process_[product].type_width, {part, other}, product, role, block);
    Operation& op = process_[id];
    op.is_signed = process_[part].is_signed || process_[other].is_signed;
    op.bits = std::min(op.type_width, process_[part].bits + process_[other].bits);
    block.operations.pop_back();
    split(id, block);
    block.operations.push_back(id);
    return id;
  }

  ValueId amount(unsigned width) {
    Operation op;
    op.kind = OpKind::kConstant;
    op.type_width = width;
    op.constant = llvm::APInt(width, block_bits_ - 1);
    op.bits = op.constant.getActiveBits();
    process_.operations.push_back(op);
    return process_.operations.size() - 1;
  }

  ValueId add(OpKind kind, unsigned width, std::vector<ValueId> operands, ValueId product, const char* role,
              Block& block) {
    Operation op;
    op.kind = kind;
    op.type_width = op.bits = width;
    op.operands = std::move(operands);
    op.block = process_[product].block;
    op.location = process_[product].location;
    op.name = process_[product].name + "_" + role;
    process_.operations.push_back(op);
    block.operations.push_back(process_.operations.size() - 1);
    return block.operations.back();
  }

  Process& process_;
  unsigned block_bits_;
};

}  // namespace

void split_products(Process& process, unsigned block_bits) { Splitter(process, block_bits).run(); }

}  // namespace hlsc
