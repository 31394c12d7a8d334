#include "design/process_builder.h"

namespace hlsc {

using namespace llvm;

ValueId ProcessBuilder::translated_intrinsic(IntrinsicInst& call) {
  auto operand = [&](unsigned i) { return value_of(call.getArgOperand(i)); };
  unsigned width = call.getType()->isIntegerTy() ? call.getType()->getIntegerBitWidth() : 0;
  auto number = [&](uint64_t value) { return constant_value(APInt(width, value)); };
  auto least = [&](CompareKind kind) {
    return select(compare(kind, operand(0), operand(1), call), operand(0), operand(1), call, name_of(call));
  };
  switch (call.getIntrinsicID()) {
    case Intrinsic::umin:
      return least(CompareKind::kULt);
    case Intrinsic::umax:
      return least(CompareKind::kUGt);
    case Intrinsic::smin:
      return least(CompareKind::kSLt);
    case Intrinsic::smax:
      return least(CompareKind::kSGt);
    case Intrinsic::abs: {
      ValueId negated = binary(OpKind::kSub, number(0), operand(0), call);
      return select(compare(CompareKind::kSLt, operand(0), number(0), call), negated, operand(0), call,
                    name_of(call));
    }
    case Intrinsic::usub_sat: {
      ValueId difference = binary(OpKind::kSub, operand(0), operand(1), call);
      return select(compare(CompareKind::kULt, operand(0), operand(1), call), number(0), difference, call);
    }
    case Intrinsic::uadd_sat: {
      ValueId sum = binary(OpKind::kAdd, operand(0), operand(1), call);
      return select(compare(CompareKind::kULt, sum, operand(0), call),
                    constant_value(APInt::getAllOnes(width)), sum, call);
    }
    case Intrinsic::sadd_sat:
    case Intrinsic::ssub_sat:
      return saturated(call, operand(0), operand(1));
    case Intrinsic::fshl:
    case Intrinsic::fshr:
      return funnel_shift(call);
    case Intrinsic::ctpop:
      return population(call, operand(0));
    case Intrinsic::ctlz:
      return leading_zeros(call, operand(0), true);
    case Intrinsic::cttz:
      return leading_zeros(call, operand(0), false);
    case Intrinsic::bswap:
      return permuted(call, operand(0), 8);
    case Intrinsic::bitreverse:
      return permuted(call, operand(0), 1);
    case Intrinsic::ucmp:
    case Intrinsic::scmp: {
      bool is_signed = call.getIntrinsicID() == Intrinsic::scmp;
      ValueId more =
          resized(compare(is_signed ? CompareKind::kSGt : CompareKind::kUGt, operand(0), operand(1), call),
                  width, false, call);
      ValueId less = compare(is_signed ? CompareKind::kSLt : CompareKind::kULt, operand(0), operand(1), call);
      return select(less, constant_value(APInt::getAllOnes(width)), more, call);
    }
    case Intrinsic::assume:
    case Intrinsic::experimental_noalias_scope_decl:
      return kNoValue;
    default:
      refuse(call, "'" + call.getCalledFunction()->getName().str() +
                       "' has no hardware form; write it with integer operations");
  }
}

ValueId ProcessBuilder::saturated(IntrinsicInst& call, ValueId first, ValueId second) {
  unsigned width = process_[first].type_width;
  OpKind kind = call.getIntrinsicID() == Intrinsic::sadd_sat ? OpKind::kAdd : OpKind::kSub;
  ValueId wide =
      binary(kind, resized(first, width + 1, true, call), resized(second, width + 1, true, call), call);
  ValueId high = constant_value(APInt::getSignedMaxValue(width)),
          low = constant_value(APInt::getSignedMinValue(width));
  ValueId over =
      compare(CompareKind::kSGt, wide, constant_value(APInt::getSignedMaxValue(width).sext(width + 1)), call);
  ValueId under =
      compare(CompareKind::kSLt, wide, constant_value(APInt::getSignedMinValue(width).sext(width + 1)), call);
  return select(over, high, select(under, low, resized(wide, width, true, call), call), call);
}

ValueId ProcessBuilder::funnel_shift(IntrinsicInst& call) {
  unsigned width = call.getType()->getIntegerBitWidth();
  bool left = call.getIntrinsicID() == Intrinsic::fshl;
  ValueId amount = resized(value_of(call.getArgOperand(2)), 2 * width, false, call);
  ValueId modulus = constant_value(APInt(2 * width, width));
  if (is_constant(amount))
    amount = constant_value(process_[amount].constant.urem(process_[modulus].constant));
  else if (isPowerOf2_32(width))
    amount = binary(OpKind::kAnd, amount, constant_value(APInt(2 * width, width - 1)), call);
  else
    amount = binary(OpKind::kURem, amount, modulus, call);
  ValueId high =
      binary(OpKind::kShl, resized(value_of(call.getArgOperand(0)), 2 * width, false, call), modulus, call);
  ValueId both =
      binary(OpKind::kOr, high, resized(value_of(call.getArgOperand(1)), 2 * width, false, call), call);
  ValueId shifted = binary(left ? OpKind::kShl : OpKind::kLShr, both, amount, call);
  if (left) shifted = binary(OpKind::kLShr, shifted, modulus, call);
  return resized(shifted, width, false, call);
}

ValueId ProcessBuilder::bit_of(ValueId value, unsigned bit, const Instruction& source) {
  unsigned width = process_[value].type_width;
  ValueId shifted = bit ? binary(OpKind::kLShr, value, constant_value(APInt(width, bit)), source) : value;
  return resized(shifted, 1, false, source);
}

ValueId ProcessBuilder::population(IntrinsicInst& call, ValueId value) {
  unsigned width = process_[value].type_width;
  std::vector<ValueId> terms;
  for (unsigned bit = 0; bit < width; ++bit)
    terms.push_back(resized(bit_of(value, bit, call), width, false, call));
  while (terms.size() > 1) {
    std::vector<ValueId> sums;
    for (size_t i = 0; i + 1 < terms.size(); i += 2)
      sums.push_back(binary(OpKind::kAdd, terms[i], terms[i + 1], call));
    if (terms.size() % 2) sums.push_back(terms.back());
    terms = sums;
  }
  return terms[0];
}

ValueId ProcessBuilder::leading_zeros(IntrinsicInst& call, ValueId value, bool from_top) {
  unsigned width = process_[value].type_width;
  ValueId count = constant_value(APInt(width, width));
  for (unsigned step = width;
       step-- > 0;) {  // The bit tested last wins: start farthest from the end that counts.
    unsigned bit = from_top ? width - 1 - step : step;
    count = select(bit_of(value, bit, call), constant_value(APInt(width, step)), count, call);
  }
  return count;
}

ValueId ProcessBuilder::permuted(IntrinsicInst& call, ValueId value, unsigned group) {
  unsigned width = process_[value].type_width;
  ValueId result = constant_value(APInt(width, 0));
  for (unsigned low = 0; low < width; low += group) {
    ValueId part =
        resized(low ? binary(OpKind::kLShr, value, constant_value(APInt(width, low)), call) : value, group,
                false, call);
    ValueId placed = resized(part, width, false, call);
    unsigned to = width - group - low;
    if (to) placed = binary(OpKind::kShl, placed, constant_value(APInt(width, to)), call);
    result = is_zero(result) ? placed : binary(OpKind::kOr, result, placed, call);
  }
  return result;
}

}  // namespace hlsc
