#include "design/process_builder.h"
#include "middle/primitives.h"

namespace hlsc {

using namespace llvm;

namespace {

/// A scaled value whose scale LLVM has moved into a product: `(x << 2) * 1` is `x * 4`.
std::pair<Value*, int64_t> unscaled(Value* value, int64_t scale) {
  auto* product = dyn_cast<OverflowingBinaryOperator>(value);
  if (!product || !(product->hasNoSignedWrap() || product->hasNoUnsignedWrap())) return {value, scale};
  auto* factor = dyn_cast<ConstantInt>(product->getOperand(1));
  if (!factor) return {value, scale};
  if (product->getOpcode() == Instruction::Shl)
    return {product->getOperand(0), scale << factor->getZExtValue()};
  if (product->getOpcode() == Instruction::Mul)
    return {product->getOperand(0), scale * factor->getSExtValue()};
  return {value, scale};
}

/// A summand of an address in bytes as elements: `value >> shift`, times `elements`, and `rest` bytes.
struct ElementTerm {
  Value* value;
  int64_t elements;
  unsigned shift = 0;
  int64_t rest = 0;
};

/// A choice between bytes 28 and 60 is one between elements 3 and 7 of 8 bytes, and 4 bytes. Nothing where
/// the value's low bits are not known.
std::optional<ElementTerm> element_term(Value* scaled, int64_t scale, int64_t stride,
                                        const DataLayout& layout) {
  auto [value, bytes] = scale % stride ? unscaled(scaled, scale) : std::pair(scaled, scale);
  if (bytes % stride == 0) return ElementTerm{value, bytes / stride};
  if (bytes <= 0 || !isPowerOf2_64(bytes) || !isPowerOf2_64(stride)) return std::nullopt;
  unsigned shift = Log2_64(stride) - Log2_64(bytes);
  KnownBits known = computeKnownBits(value, layout);
  if ((known.Zero | known.One).countr_one() < shift) return std::nullopt;
  int64_t low = known.One.getLoBits(shift).getZExtValue();
  return ElementTerm{value, 1, shift, low * bytes};
}

}  // namespace

Address ProcessBuilder::decode(Value* pointer, const Instruction& access) {
  if (is_element_address(pointer)) return decode_element(*cast<CallInst>(pointer), access);
  APInt constant(64, 0);
  MapVector<Value*, APInt> terms;
  Value* base = pointer;
  while (auto* gep = dyn_cast<GEPOperator>(base)) {
    if (!gep->collectOffset(layout_, 64, terms, constant))
      refuse(access, "this address has no simple form; use subscripts");
    base = gep->getPointerOperand();
  }
  Address address;
  address.object = &object_at(base, access);
  last_object_pointer_ = base;
  MemoryObject& object = *address.object;
  int64_t stride = 0;
  if (!object.leaves.empty() && !object.leaves[0].strides.empty()) stride = object.leaves[0].strides.back();
  int64_t offset = constant.getSExtValue();
  std::vector<ElementTerm> parts;
  for (auto& [scaled, scale] : terms) {
    if (!stride) refuse(access, "'" + object.name + "' is accessed with a subscript but is no array");
    std::optional<ElementTerm> part = element_term(scaled, scale.getSExtValue(), stride, layout_);
    if (!part)
      refuse(access,
             "this address in '" + object.name + "' is not a whole number of elements; use subscripts");
    offset += part->rest;
    parts.push_back(*part);
  }
  int64_t member = stride ? ((offset % stride) + stride) % stride : offset;
  bool found = false;
  for (size_t leaf = 0; leaf < object.leaves.size(); ++leaf)
    if (static_cast<int64_t>(object.leaves[leaf].byte_offset) == member) {
      address.leaf = leaf;
      found = true;
    }
  if (!found)
    refuse(access, "this access to '" + object.name +
                       "' does not match one of its elements; use members and subscripts without casts");
  check_width(object.leaves[address.leaf], access);
  if (!stride) return address;
  address.is_linear = true;
  ValueId index = constant_value(APInt(64, (offset - member) / stride, true));
  for (const ElementTerm& part : parts) {
    ValueId term = resized(value_of(part.value), 64, true, access);
    if (part.shift) term = binary(OpKind::kAShr, term, constant_value(APInt(64, part.shift)), access);
    if (part.elements != 1)
      term = binary(OpKind::kMul, term, constant_value(APInt(64, part.elements, true)), access);
    index = is_zero(index) ? term : binary(OpKind::kAdd, term, index, access);
  }
  address.subscripts = {index};
  return address;
}

Address ProcessBuilder::decode_element(CallInst& call, const Instruction& access) {
  Address address;
  last_object_pointer_ = call.getArgOperand(0);
  address.object = &object_at(last_object_pointer_, access);
  uint64_t offset = cast<ConstantInt>(call.getArgOperand(1))->getZExtValue();
  for (size_t leaf = 0; leaf < address.object->leaves.size(); ++leaf)
    if (address.object->leaves[leaf].byte_offset == offset) address.leaf = leaf;
  check_width(address.object->leaves[address.leaf], access);
  for (unsigned i = 2; i < call.arg_size(); ++i) address.values.push_back(call.getArgOperand(i));
  for (Value* subscript : address.values) address.subscripts.push_back(value_of(subscript));
  return address;
}

void ProcessBuilder::check_width(const MemoryLeaf& leaf, const Instruction& access) {
  Type* type = access.getType();
  if (auto* store = dyn_cast<StoreInst>(&access)) type = store->getValueOperand()->getType();
  if (auto* call = dyn_cast<CallInst>(&access); call && primitive_of(*call) == Primitive::kStore)
    type = call->getArgOperand(1)->getType();
  if (!type->isIntegerTy())
    refuse(access,
           "only integers can be loaded and stored here; pointers and floating point have no hardware form");
  if (type->getIntegerBitWidth() > leaf.bytes * 8)
    refuse(access, "this access covers several elements of an array at once; access them one by one");
}

ProcessBuilder::Place ProcessBuilder::place_of(const Address& address, const Instruction& access) {
  MemoryObject& object = *address.object;
  const MemoryLeaf& shape = object.leaves[address.leaf];
  const std::vector<Partition>& partitions = object.partitions[address.leaf];
  Place result{constant_value(APInt(64, 0)), constant_value(APInt(64, 0)), 1};
  if (address.is_linear) {
    result.address = address.subscripts[0];
    return result;
  }
  bool registers = is_fully_partitioned(object, address.leaf);
  for (size_t d = 0; d < shape.dims.size(); ++d) {
    uint64_t count = registers ? 1 : bank_count(partitions[d], shape.dims[d]);
    uint64_t words = (shape.dims[d] + count - 1) / count;
    ValueId subscript = address.subscripts[d];
    bool is_block = partitions[d].kind == Partition::kBlock;
    std::optional<uint64_t> block;
    if (is_block && count > 1) block = block_of(address.values[d], words);
    ValueId quotient =
        block ? constant_value(APInt(64, *block)) : divided(subscript, is_block ? words : count, access);
    std::optional<uint64_t> lane;
    if (!is_block && count > 1) lane = lane_of(address.values[d], count);
    ValueId remainder =
        lane ? constant_value(APInt(64, *lane)) : remainder_of(subscript, is_block ? words : count, access);
    result.bank = combined(result.bank, count, is_block ? quotient : remainder, access);
    result.address = combined(result.address, words, is_block ? remainder : quotient, access);
    result.banks *= count;
  }
  return result;
}

std::optional<uint64_t> ProcessBuilder::block_of(Value* subscript, uint64_t words) {
  ConstantRange range = evolution_.getUnsignedRange(evolution_.getSCEV(subscript));
  uint64_t first = range.getUnsignedMin().udiv(words).getZExtValue(),
           last = range.getUnsignedMax().udiv(words).getZExtValue();
  return first == last ? std::optional(first) : std::nullopt;
}

std::optional<uint64_t> ProcessBuilder::lane_of(Value* subscript, uint64_t banks) {
  if (!isPowerOf2_64(banks)) return std::nullopt;
  KnownBits known = computeKnownBits(subscript, layout_);
  if ((known.Zero | known.One).countr_one() < Log2_64(banks)) return std::nullopt;
  return known.One.getLoBits(Log2_64(banks)).getZExtValue();
}

ValueId ProcessBuilder::combined(ValueId outer, uint64_t size, ValueId inner, const Instruction& access) {
  if (is_zero(outer)) return inner;
  if (is_constant(outer) && is_constant(inner))
    return constant_value(process_[outer].constant * size + process_[inner].constant);
  ValueId scaled = size == 1 ? outer
                   : is_constant(outer)
                       ? constant_value(process_[outer].constant * size)
                       : binary(OpKind::kMul, outer, constant_value(APInt(64, size)), access);
  return is_zero(inner) ? scaled : binary(OpKind::kAdd, scaled, inner, access);
}

ValueId ProcessBuilder::divided(ValueId value, uint64_t divisor, const Instruction& access) {
  if (divisor == 1) return value;
  if (is_constant(value)) return constant_value(process_[value].constant.udiv(divisor));
  if (isPowerOf2_64(divisor))
    return binary(OpKind::kLShr, value, constant_value(APInt(64, Log2_64(divisor))), access);
  return binary(OpKind::kUDiv, value, constant_value(APInt(64, divisor)), access);
}

ValueId ProcessBuilder::remainder_of(ValueId value, uint64_t divisor, const Instruction& access) {
  if (divisor == 1) return constant_value(APInt(64, 0));
  if (is_constant(value)) return constant_value(APInt(64, process_[value].constant.urem(divisor)));
  if (isPowerOf2_64(divisor))
    return binary(OpKind::kAnd, value, constant_value(APInt(64, divisor - 1)), access);
  return binary(OpKind::kURem, value, constant_value(APInt(64, divisor)), access);
}

}  // namespace hlsc
