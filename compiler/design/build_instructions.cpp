#include <llvm/Demangle/Demangle.h>

#include "design/process_builder.h"
#include "middle/primitives.h"
#include "middle/source_location.h"

namespace hlsc {

using namespace llvm;

namespace {

/// LLVM's opcodes that are one operation each.
const std::map<unsigned, OpKind>& operation_kinds() {
  static const std::map<unsigned, OpKind> kinds = {
      {Instruction::Add, OpKind::kAdd},     {Instruction::Sub, OpKind::kSub},
      {Instruction::Mul, OpKind::kMul},     {Instruction::UDiv, OpKind::kUDiv},
      {Instruction::SDiv, OpKind::kSDiv},   {Instruction::URem, OpKind::kURem},
      {Instruction::SRem, OpKind::kSRem},   {Instruction::And, OpKind::kAnd},
      {Instruction::Or, OpKind::kOr},       {Instruction::Xor, OpKind::kXor},
      {Instruction::Shl, OpKind::kShl},     {Instruction::LShr, OpKind::kLShr},
      {Instruction::AShr, OpKind::kAShr},   {Instruction::ZExt, OpKind::kZExt},
      {Instruction::SExt, OpKind::kSExt},   {Instruction::Trunc, OpKind::kTrunc},
      {Instruction::ICmp, OpKind::kCompare}};
  return kinds;
}

}  // namespace

void ProcessBuilder::build_instruction(Instruction& instruction) {
  if (isa<GetElementPtrInst>(instruction) || isa<AllocaInst>(instruction) ||
      isa<DbgInfoIntrinsic>(instruction) || isa<InsertValueInst>(instruction) ||
      is_element_address(&instruction) || instruction.isLifetimeStartOrEnd())
    return;
  ValueId id = translated(instruction);
  if (id == kNoValue) return;
  values_[&instruction] = id;
  refine(id, instruction);
}

std::string ProcessBuilder::name_of(Instruction& instruction) {
  SmallVector<DbgValueInst*, 2> intrinsics;
  SmallVector<DbgVariableRecord*, 2> records;
  findDbgValues(intrinsics, &instruction, &records);
  for (DbgVariableRecord* record : records)
    if (!record->getVariable()->isArtificial() && record->getVariable()->getName() != "this")
      return record->getVariable()->getName().str();
  std::string name = variable_part(instruction.getName().str());
  static const std::set<std::string> empty_names = {
      "conv",   "add",    "sub",     "mul",     "cmp",    "shl",      "shr",    "and",  "or",
      "xor",    "cond",   "loadedv", "storedv", "tobool", "frombool", "inc",    "dec",  "div",
      "rem",    "narrow", "spec",    "sext",    "trunc",  "zext",     "lnot",   "call", "ref",
      "retval", "tmp",    "agg",     "lor",     "land",   "not",      "indvars"};
  return empty_names.count(name) ? "" : name;
}

ValueId ProcessBuilder::translated(Instruction& instruction) {
  if (accessed_pointer(instruction)) return is_store(instruction) ? store(instruction) : load(instruction);
  if (auto* call = dyn_cast<CallInst>(&instruction)) return translated_call(*call);
  if (instruction.getType()->isFloatingPointTy())
    refuse(instruction, "floating point has no operators yet; use ap_fixed");
  if (!instruction.getType()->isIntegerTy())
    refuse(instruction,
           "this pointer may point to several objects; access each array by its own name with a subscript");
  Operation operation;
  operation.type_width = instruction.getType()->getIntegerBitWidth();
  if (isa<PHINode>(instruction)) {
    operation.kind = OpKind::kPhi;
    ValueId phi = add(operation, instruction, name_of(instruction));
    if (!process_[phi].location.line) process_[phi].location = process_.blocks[current_block_].location;
    return phi;
  }
  if (isa<FreezeInst>(instruction)) return value_of(instruction.getOperand(0));
  for (Value* operand : instruction.operands()) operation.operands.push_back(value_of(operand));
  if (isa<SelectInst>(instruction)) return translated_select(instruction, operation);
  if (auto* comparison = dyn_cast<ICmpInst>(&instruction)) {
    operation.compare = compare_kind(comparison->getPredicate());
    operation.operand_width = process_[operation.operands[0]].type_width;
  }
  auto kind = operation_kinds().find(instruction.getOpcode());
  if (kind == operation_kinds().end())
    refuse(instruction, std::string("'") + instruction.getOpcodeName() +
                            "' has no hardware form; use integers, ap types and subscripts");
  operation.kind = kind->second;
  return add(operation, instruction, name_of(instruction));
}

ValueId ProcessBuilder::translated_select(Instruction& instruction, Operation operation) {
  auto [condition, yes, no] = std::tie(operation.operands[0], operation.operands[1], operation.operands[2]);
  auto is_bit = [&](ValueId id, bool bit) {
    return operation.type_width == 1 && is_constant(id) && process_[id].constant == bit;
  };
  operation.kind = OpKind::kSelect;
  if (is_bit(no, false)) {
    operation.kind = OpKind::kAnd;
    operation.operands = {condition, yes};
  } else if (is_bit(yes, true)) {
    operation.kind = OpKind::kOr;
    operation.operands = {condition, no};
  }
  return add(operation, instruction, name_of(instruction));
}

CompareKind ProcessBuilder::compare_kind(CmpInst::Predicate predicate) {
  static const std::map<CmpInst::Predicate, CompareKind> kinds = {
      {CmpInst::ICMP_EQ, CompareKind::kEq},   {CmpInst::ICMP_NE, CompareKind::kNe},
      {CmpInst::ICMP_ULT, CompareKind::kULt}, {CmpInst::ICMP_ULE, CompareKind::kULe},
      {CmpInst::ICMP_UGT, CompareKind::kUGt}, {CmpInst::ICMP_UGE, CompareKind::kUGe},
      {CmpInst::ICMP_SLT, CompareKind::kSLt}, {CmpInst::ICMP_SLE, CompareKind::kSLe},
      {CmpInst::ICMP_SGT, CompareKind::kSGt}, {CmpInst::ICMP_SGE, CompareKind::kSGe}};
  return kinds.at(predicate);
}

ValueId ProcessBuilder::predicate_of(Value* predicate) {
  auto* constant = dyn_cast<ConstantInt>(predicate);
  return constant && constant->isOne() ? kNoValue : value_of(predicate);
}

ValueId ProcessBuilder::translated_call(CallInst& call) {
  if (int process = process_called(call); process >= 0) {
    build_instance(call, process);
    return kNoValue;
  }
  switch (primitive_of(call)) {
    case Primitive::kRead:
      return read_stream(call);
    case Primitive::kWrite:
      write_stream(call);
      return kNoValue;
    case Primitive::kEmpty:
    case Primitive::kFull:
      return stream_status(call);
    case Primitive::kResult:
      set_result(value_of(call.getArgOperand(0)), call);
      return kNoValue;
    default:
      break;
  }
  if (auto* intrinsic = dyn_cast<IntrinsicInst>(&call)) return translated_intrinsic(*intrinsic);
  refuse(call, reason_against(call));
}

std::string ProcessBuilder::reason_against(const CallInst& call) {
  if (call.isInlineAsm()) return "inline assembly has no hardware form; write it in C++";
  if (!call.getCalledFunction())
    return "a function pointer has no hardware form; call the function by its name";
  std::string name = call.getCalledFunction()->getName().str();
  std::string readable = demangle(name);
  bool is_heap = readable.find("operator new") == 0 || readable.find("operator delete") == 0;
  if (is_heap || readable.find("std::__throw_") == 0 || readable.find("std::__cxx11::") == 0)
    return "a container of the standard library needs a heap here, which hardware lacks; use an array of "
           "fixed "
           "size";
  return "the call of '" + readable + "' cannot be inlined; give the function's source among the files";
}

void ProcessBuilder::refine(ValueId id, Instruction& instruction) {
  if (!instruction.getType()->isIntegerTy()) return;
  Operation& operation = process_[id];
  if (operation.kind == OpKind::kConstant || operation.kind == OpKind::kInput ||
      operation.type_width != instruction.getType()->getIntegerBitWidth())
    return;
  unsigned width = operation.type_width;
  unsigned unsigned_bits = width - computeKnownBits(&instruction, layout_).countMinLeadingZeros();
  unsigned signed_bits = width - ComputeNumSignBits(&instruction, layout_) + 1;
  if (evolution_.isSCEVable(instruction.getType())) {
    const SCEV* form = evolution_.getSCEV(&instruction);
    unsigned_bits = std::min(unsigned_bits, evolution_.getUnsignedRangeMax(form).getActiveBits());
    unsigned low = evolution_.getSignedRangeMin(form).getSignificantBits(),
             high = evolution_.getSignedRangeMax(form).getSignificantBits();
    signed_bits = std::min(signed_bits, std::max(low, high));
  }
  bool is_signed = signed_bits < unsigned_bits;
  unsigned bits = std::max(1u, is_signed ? signed_bits : unsigned_bits);
  if (bits < operation.bits) {
    operation.bits = bits;
    operation.is_signed = is_signed;
  }
}

}  // namespace hlsc
