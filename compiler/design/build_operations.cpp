#include <llvm/ADT/StringExtras.h>

#include "design/process_builder.h"
#include "middle/source_location.h"

namespace hlsc {

using namespace llvm;

ValueId ProcessBuilder::add(Operation operation, const Instruction& source, const std::string& wanted_name) {
  operation.block = current_block_;
  operation.location = location_of(source);
  operation.bits = operation.type_width;
  operation.name = names_.unique(wanted_name.empty() ? kind_name(operation.kind) : wanted_name);
  process_.operations.push_back(operation);
  ValueId id = process_.operations.size() - 1;
  process_.blocks[current_block_].operations.push_back(id);
  return id;
}

ValueId ProcessBuilder::add_shared(const Operation& operation, const Instruction& source,
                                   const std::string& wanted_name) {
  auto key = std::make_tuple(current_block_, operation.kind, operation.type_width, operation.operand_width,
                             operation.compare, operation.operands);
  auto known = shared_.find(key);
  if (known != shared_.end()) return known->second;
  return shared_[key] = add(operation, source, wanted_name);
}

const char* ProcessBuilder::kind_name(OpKind kind) {
  switch (kind) {
    case OpKind::kAdd:
      return "sum";
    case OpKind::kSub:
      return "difference";
    case OpKind::kMul:
      return "product";
    case OpKind::kUDiv:
    case OpKind::kSDiv:
      return "quotient";
    case OpKind::kURem:
    case OpKind::kSRem:
      return "remainder";
    case OpKind::kAnd:
      return "both";
    case OpKind::kOr:
      return "either";
    case OpKind::kXor:
      return "differs";
    case OpKind::kShl:
    case OpKind::kLShr:
    case OpKind::kAShr:
      return "shifted";
    case OpKind::kCompare:
      return "test";
    case OpKind::kSelect:
      return "chosen";
    case OpKind::kLoad:
      return "loaded";
    case OpKind::kRead:
      return "data";
    default:
      return "value";
  }
}

ValueId ProcessBuilder::constant_value(const APInt& constant) {
  auto key = std::make_pair(constant.getBitWidth(), toString(constant, 16, false));
  auto known = constants_.find(key);
  if (known != constants_.end()) return known->second;
  Operation operation;
  operation.kind = OpKind::kConstant;
  operation.type_width = constant.getBitWidth();
  operation.constant = constant;
  operation.bits = std::max(1u, std::min(constant.getActiveBits(), constant.getSignificantBits()));
  operation.is_signed = constant.getSignificantBits() < constant.getActiveBits();
  process_.operations.push_back(operation);
  return constants_[key] = process_.operations.size() - 1;
}

ValueId ProcessBuilder::binary(OpKind kind, ValueId first, ValueId second, const Instruction& source) {
  Operation operation;
  operation.kind = kind;
  operation.type_width = process_[first].type_width;
  operation.operands = {first, second};
  return add_shared(operation, source, kind == OpKind::kAdd || kind == OpKind::kMul ? "index" : "");
}

ValueId ProcessBuilder::compare(CompareKind kind, ValueId first, ValueId second, const Instruction& source) {
  Operation operation;
  operation.kind = OpKind::kCompare;
  operation.compare = kind;
  operation.operand_width = process_[first].type_width;
  operation.type_width = 1;
  operation.operands = {first, second};
  return add_shared(operation, source);
}

ValueId ProcessBuilder::select(ValueId condition, ValueId yes, ValueId no, const Instruction& source,
                               const std::string& name) {
  Operation operation;
  operation.kind = OpKind::kSelect;
  operation.type_width = process_[yes].type_width;
  operation.operands = {condition, yes, no};
  return add_shared(operation, source, name);
}

ValueId ProcessBuilder::resized(ValueId value, unsigned width, bool is_signed, const Instruction& source) {
  unsigned from = process_[value].type_width;
  if (from == width) return value;
  if (is_constant(value))
    return constant_value(is_signed ? process_[value].constant.sextOrTrunc(width)
                                    : process_[value].constant.zextOrTrunc(width));
  Operation operation;
  operation.kind = from > width ? OpKind::kTrunc : is_signed ? OpKind::kSExt : OpKind::kZExt;
  operation.type_width = width;
  operation.operands = {value};
  return add_shared(operation, source, process_[value].name);
}

ValueId ProcessBuilder::value_of(Value* value) {
  auto known = values_.find(value);
  if (known != values_.end()) return known->second;
  if (auto* constant = dyn_cast<ConstantInt>(value)) return constant_value(constant->getValue());
  if (isa<UndefValue>(value) && value->getType()->isIntegerTy())
    return constant_value(APInt(value->getType()->getIntegerBitWidth(), 0));
  if (auto* instruction = dyn_cast<Instruction>(value))
    refuse(*instruction, "this value has no hardware form; use integers, ap types and subscripts");
  throw CompileError(info_->location, "a value of '" + process_.source_name +
                                          "' has no hardware form; use integers, ap types and subscripts");
}

}  // namespace hlsc
