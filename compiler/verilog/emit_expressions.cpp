#include <algorithm>

#include "verilog/process_emitter.h"
#include "verilog/text.h"

namespace hlsc {

std::string ProcessEmitter::expression(ValueId id, Place at) {
  const Operation& op = process_[id];
  unsigned w = op.bits;
  auto operand = [&](size_t i, unsigned width) { return text(op.operands[i], width, at); };
  switch (op.kind) {
    case OpKind::kAdd:
      return operand(0, w) + " + " + operand(1, w);
    case OpKind::kSub:
      return operand(0, w) + " - " + operand(1, w);
    case OpKind::kMul:
      return product(op, at);
    case OpKind::kUDiv:
      return operand(0, w) + " / " + operand(1, w);
    case OpKind::kURem:
      return operand(0, w) + " % " + operand(1, w);
    case OpKind::kAnd:
      return operand(0, w) + " & " + operand(1, w);
    case OpKind::kOr:
      return operand(0, w) + " | " + operand(1, w);
    case OpKind::kXor:
      return is_all_ones(op.operands[1], w) ? "~" + operand(0, w) : operand(0, w) + " ^ " + operand(1, w);
    case OpKind::kShl:
      return shifted_left(op, at);
    case OpKind::kLShr:
    case OpKind::kAShr:
      return shifted_right(op, at);
    case OpKind::kSelect:
      return operand(0, 1) + " ? " + operand(1, w) + " : " + operand(2, w);
    case OpKind::kZExt:
      return zero_extended(op, at);
    case OpKind::kSExt:
      return sign_extended(op, at);
    case OpKind::kTrunc:
      return operand(0, w);
    case OpKind::kConcat:
      return concatenation(op, at);
    case OpKind::kCompare:
      return comparison(op, at);
    case OpKind::kRead:
      return process_.streams[op.object].name + "_dout";
    case OpKind::kEmpty:
      return "~" + process_.streams[op.object].name + "_empty_n";
    case OpKind::kFull:
      return "~" + process_.streams[op.object].name + "_full_n";
    case OpKind::kLoad:
      return loaded(id, at);
    default:
      throw CompileError(op.location,
                         "this operation has no Verilog form yet; write it with + - * and shifts");
  }
}

bool ProcessEmitter::is_all_ones(ValueId id, unsigned width) const {
  return is_constant(id) && process_[id].constant.sextOrTrunc(width).isAllOnes();
}

std::string ProcessEmitter::product(const Operation& op, Place at) {
  const Operation &a = process_[op.operands[0]], &b = process_[op.operands[1]];
  bool is_signed = (a.is_signed && a.bits < op.bits) || (b.is_signed && b.bits < op.bits);
  auto factor = [&](ValueId id) {
    const Operation& value = process_[id];
    unsigned width = std::min(value.bits, op.bits);
    if (!is_signed) return text(id, width, at);
    bool needs_zero = !value.is_signed && value.bits < op.bits;
    return "$signed(" + text(id, width + (needs_zero ? 1 : 0), at) + ")";
  };
  return factor(op.operands[0]) + " * " + factor(op.operands[1]);
}

std::string ProcessEmitter::shifted_left(const Operation& op, Place at) {
  if (!is_constant(op.operands[1])) return text(op.operands[0], op.bits, at) + " << " + amount(op, at);
  uint64_t count = process_[op.operands[1]].constant.getLimitedValue(op.bits);
  if (count == 0) return text(op.operands[0], op.bits, at);
  if (count >= op.bits) return std::to_string(op.bits) + "'d0";
  return "{" + text(op.operands[0], op.bits - count, at) + ", " + std::to_string(count) + "'d0}";
}

std::string ProcessEmitter::amount(const Operation& op, Place at) {
  const Operation& count = process_[op.operands[1]];
  return text(op.operands[1], count.is_signed ? count.type_width : count.bits, at);
}

std::string ProcessEmitter::shifted_right(const Operation& op, Place at) {
  const Operation& value = process_[op.operands[0]];
  bool arithmetic = op.kind == OpKind::kAShr;
  // Signed representations have copies of the sign up to the type's width.
  unsigned source = value.is_signed && !arithmetic ? op.type_width : value.bits;
  bool fill_sign = arithmetic && (value.is_signed || value.bits == op.type_width);
  if (!is_constant(op.operands[1])) {
    unsigned width = std::max(source, op.bits);
    std::string from = text(op.operands[0], width, at);
    if (fill_sign && !value.is_signed) from = sign_filled(op.operands[0], width, at);
    std::string result =
        fill_sign ? "$signed(" + from + ") >>> " + amount(op, at) : from + " >> " + amount(op, at);
    return width == op.bits ? result : wide_slice(op, result, width);
  }
  uint64_t count = process_[op.operands[1]].constant.getLimitedValue(op.type_width);
  if (count == 0) return text(op.operands[0], op.bits, at);
  if (is_constant(op.operands[0])) {
    const llvm::APInt& constant = process_[op.operands[0]].constant;
    return literal_text(
        (arithmetic ? constant.ashr(count) : constant.lshr(count)).trunc(std::min(op.bits, op.type_width)),
        op.bits);
  }
  std::string name = signal(op.operands[0], at);
  unsigned top =
      value.is_signed || fill_sign ? std::min<unsigned>(count + op.bits, op.type_width) : value.bits;
  if (top > value.bits) {  // Needs bits above the representation.
    std::string wide = auxiliary(op, top, resized_text(name, value.bits, value.is_signed || fill_sign, top));
    return slice(wide, top, count, op.bits, fill_sign || (value.is_signed && arithmetic));
  }
  return slice(name, value.bits, count, op.bits, fill_sign || (value.is_signed && arithmetic));
}

std::string ProcessEmitter::slice(const std::string& name, unsigned bits, uint64_t low, unsigned width,
                                  bool fill_sign) {
  if (low >= bits)
    return fill_sign
               ? resized_text(bits == 1 ? name : name + "[" + std::to_string(bits - 1) + "]", 1, true, width)
               : std::to_string(width) + "'d0";
  unsigned high = std::min<uint64_t>(low + width, bits) - 1;
  std::string part = bits == 1     ? name
                     : high == low ? name + "[" + std::to_string(low) + "]"
                                   : name + "[" + std::to_string(high) + ":" + std::to_string(low) + "]";
  unsigned have = high - low + 1;
  if (have == width) return part;
  std::string count = std::to_string(width - have);
  if (!fill_sign) return "{" + count + "'d0, " + part + "}";
  std::string sign = bits == 1 ? name : name + "[" + std::to_string(bits - 1) + "]";
  return "{{" + count + "{" + sign + "}}, " + part + "}";
}

std::string ProcessEmitter::auxiliary(const Operation& op, unsigned width, const std::string& value) {
  std::string name = names_.unique(op.name + "_wide");
  wires_ << "    wire" << range_text(width) << " " << name << " = " << value << ";\n";
  return name;
}

std::string ProcessEmitter::wide_slice(const Operation& op, const std::string& value, unsigned width) {
  std::string name = auxiliary(op, width, value);
  return name + (op.bits == 1 ? "[0]" : "[" + std::to_string(op.bits - 1) + ":0]");
}

std::string ProcessEmitter::concatenation(const Operation& op, Place at) {
  std::string parts;
  for (ValueId part : op.operands)
    parts = text(part, process_[part].type_width, at) + (parts.empty() ? "" : ", " + parts);
  return "{" + parts + "}";
}

std::string ProcessEmitter::zero_extended(const Operation& op, Place at) {
  unsigned low = std::min(op.bits, op.operand_width);
  std::string part = text(op.operands[0], low, at);
  return low == op.bits ? part : "{" + std::to_string(op.bits - low) + "'d0, " + part + "}";
}

std::string ProcessEmitter::sign_extended(const Operation& op, Place at) {
  const Operation& source = process_[op.operands[0]];
  if (source.is_signed || source.bits < op.operand_width || op.bits <= source.bits)
    return text(op.operands[0], op.bits, at);
  return sign_filled(op.operands[0], op.bits, at);
}

std::string ProcessEmitter::sign_filled(ValueId id, unsigned width, Place at) {
  const Operation& op = process_[id];
  if (op.kind == OpKind::kConstant) return literal_text(op.constant.sextOrTrunc(width), width);
  return resized_text(signal(id, at), op.bits, true, width);
}

/// Below 2^k all bits from k up are 0, below 0 the sign is 1: tools that see an order make a carry chain of
/// it.
std::string ProcessEmitter::top_bits_test(const Operation& op, unsigned width, bool is_signed, Place at) {
  const Operation &value = process_[op.operands[0]], &bound = process_[op.operands[1]];
  bool is_below = op.compare == CompareKind::kULt || op.compare == CompareKind::kSLt;
  bool is_above = op.compare == CompareKind::kUGt || op.compare == CompareKind::kSGt;
  bool is_whole = value.kind != OpKind::kConstant && value.bits == width && width > 1;
  if (!is_whole || bound.kind != OpKind::kConstant || !(is_below || is_above)) return "";
  std::string name = text(op.operands[0], width, at);
  // x > c is x >= c + 1.
  llvm::APInt limit =
      bound.is_signed ? bound.constant.sextOrTrunc(width + 1) : bound.constant.zextOrTrunc(width + 1);
  if (is_above) ++limit;
  if (is_signed) {
    if (!limit.isZero()) return "";
    return (is_above ? "~" : "") + slice(name, width, width - 1, 1, false);
  }
  unsigned low = limit.isPowerOf2() ? limit.logBase2() : 0;
  if (low == 0 || low >= width) return "";
  return slice(name, width, low, width - low, false) + (is_below ? " == " : " != ") +
         literal_text(llvm::APInt(width - low, 0), width - low);
}

std::string ProcessEmitter::comparison(const Operation& op, Place at) {
  const Operation &a = process_[op.operands[0]], &b = process_[op.operands[1]];
  auto bits_as = [&](const Operation& value, bool as_signed) {
    return as_signed && !value.is_signed && value.bits < op.operand_width ? value.bits + 1 : value.bits;
  };
  bool is_equality = op.compare == CompareKind::kEq || op.compare == CompareKind::kNe;
  bool compares_signed = op.compare >= CompareKind::kSLt;
  bool any_signed = a.is_signed || b.is_signed;
  unsigned width;
  bool use_signed = false;
  if (is_equality) {
    width = std::min(op.operand_width, std::max(bits_as(a, any_signed), bits_as(b, any_signed)));
  } else if (compares_signed) {
    bool plain = !any_signed && a.bits < op.operand_width && b.bits < op.operand_width;
    use_signed = !plain;
    width = plain ? std::max(a.bits, b.bits)
                  : std::min(op.operand_width, std::max(bits_as(a, true), bits_as(b, true)));
  } else {
    width = any_signed ? op.operand_width : std::max(a.bits, b.bits);
  }
  std::string top = top_bits_test(op, width, use_signed, at);
  if (!top.empty()) return top;
  std::string left = text(op.operands[0], width, at), right = text(op.operands[1], width, at);
  if (use_signed) {
    left = "$signed(" + left + ")";
    right = "$signed(" + right + ")";
  }
  static const char* const signs[] = {"==", "!=", "<", "<=", ">", ">=", "<", "<=", ">", ">="};
  return left + " " + signs[static_cast<int>(op.compare)] + " " + right;
}

std::string ProcessEmitter::loaded(ValueId id, Place at) {
  const Operation& op = process_[id];
  const Memory& memory = process_.memories[op.object];
  std::string word;
  if (memory.load_latency > 0) {
    word = memory.name + "_q";
    if (memory.kind == MemoryKind::kPort) word += std::to_string(schedule_.port[id]);
  } else if (memory.kind == MemoryKind::kRom) {
    word = memory.name + "_at(" + text(op.operands[0], address_bits(memory.depth), at) + ")";
    if (op.bits != memory.width) word = auxiliary(op, memory.width, word);
  } else if (memory.depth == 1) {
    word = memory.name;
  } else {
    word = memory.name + "[" + text(op.operands[0], address_bits(memory.depth), at) + "]";
    if (op.bits != memory.width) word = auxiliary(op, memory.width, word);
  }
  return resized_text(word, memory.width, memory.is_signed, op.bits);
}

}  // namespace hlsc
