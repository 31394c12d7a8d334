#include "expression_generator.h"

#include <algorithm>

namespace hlsc::differential {

Type ExpressionGenerator::native_type() {
  static const std::vector<Type> types = {
      {Kind::kNative, 8, true, 0, "signed char"}, {Kind::kNative, 8, false, 0, "unsigned char"},
      {Kind::kNative, 16, true, 0, "short"},      {Kind::kNative, 16, false, 0, "unsigned short"},
      {Kind::kNative, 32, true, 0, "int"},        {Kind::kNative, 32, false, 0, "unsigned"},
      {Kind::kNative, 64, true, 0, "long long"},  {Kind::kNative, 64, false, 0, "unsigned long long"},
      {Kind::kNative, 1, false, 0, "bool"},       {Kind::kNative, 32, true, 0, "int"}};
  return pick(types);
}

Type ExpressionGenerator::fixed_type() {
  static const std::vector<std::string> quantisation = {
      "AP_TRN", "AP_RND", "AP_TRN_ZERO", "AP_RND_ZERO", "AP_RND_MIN_INF", "AP_RND_INF", "AP_RND_CONV"};
  static const std::vector<std::string> overflow = {"AP_WRAP", "AP_SAT", "AP_SAT_ZERO", "AP_SAT_SYM"};
  int width = between(2, 28), whole = between(-2, width + 2);
  bool is_signed = chance(60);
  return {Kind::kFixed, width, is_signed, whole,
          fmt::format("ap_{}fixed<{}, {}, {}, {}>", is_signed ? "" : "u", width, whole, pick(quantisation),
                      pick(overflow))};
}

std::string ExpressionGenerator::native_value(const Type& type, int depth) {
  Type a = native_type(), b = native_type();
  std::string left = value(a, depth - 1), right = value(b, depth - 1);
  int wide = std::max(a.width, 32);
  switch (below(9)) {
    case 0:
      return fmt::format("({})({} << ({} & {}))", type.spelling, left, right, wide - 1);
    case 1:
      return fmt::format("({})({} >> ({} & {}))", type.spelling, left, right, wide - 1);
    case 2:
      return fmt::format("({})({} / (({} & 63) + 1))", type.spelling, left, right);
    case 3:
      return fmt::format("({})({} % {})", type.spelling, value(int_type(), depth - 1), chance(50) ? -7 : 11);
    case 4:
      return fmt::format("({})(~{})", type.spelling, value(int_type(), depth - 1));
    case 5:
      return fmt::format("({})(-{})", type.spelling, value(int_type(), depth - 1));
    case 6:
      return fmt::format("({}){}", type.spelling, condition(depth - 1));
    default: {
      static const std::vector<std::string> operators = {"+", "-", "*", "&", "|", "^", "+", "-"};
      return fmt::format("({})({} {} {})", type.spelling, left, pick(operators), right);
    }
  }
}

std::string ExpressionGenerator::integer_value(const Type& type, int depth) {
  Type a = integer_type(), b = integer_type();
  std::string left = value(a, depth - 1), right = value(b, depth - 1);
  const std::string& target = type.spelling;
  switch (below(10)) {
    case 0:
      return fmt::format("{}({} << ({} & {}))", target, left, value(int_type(), 0),
                         std::min(a.width, 31) - (a.width > 1));
    case 1:
      return fmt::format("{}({} >> ({} & 15))", target, left, value(int_type(), 0));
    case 2:
    case 3: {  // A guarded division: the divisor is a name, so that it is evaluated once.
      if (a.width > 40 || b.width > 40) return fmt::format("{}({} ^ {})", target, left, right);
      return fmt::format("{}({} {} ({} | {}(1)))", target, left, chance(50) ? "/" : "%", right, b.spelling);
    }
    case 4: {
      int high = below(a.width), low = below(high + 1);
      return fmt::format("{0}({1}({2}).range({3}, {4}))", target, a.spelling, left, high, low);
    }
    case 5:
      return fmt::format("{}((bool){}({})[{}])", target, a.spelling, left, below(a.width));
    case 6:
      if (a.width + b.width > 90) return fmt::format("{}({} | {})", target, left, right);
      return fmt::format("{}(({}({}), {}({})))", target, a.spelling, left, b.spelling, right);
    case 7:
      return fmt::format("{}({}{})", target, chance(50) ? "~" : "-", left);
    default: {
      static const std::vector<std::string> operators = {"+", "-", "*", "&", "|", "^"};
      return fmt::format("{}({} {} {})", target, left, pick(operators), right);
    }
  }
}

std::string ExpressionGenerator::fixed_value(const Type& type, int depth) {
  Type a = fixed_type(), b = fixed_type();
  std::string left = value(a, depth - 1), right = value(b, depth - 1);
  if (chance(15)) return fmt::format("{}({})", type.spelling, value(integer_type(), depth - 1));
  if (chance(10)) return fmt::format("{}(-{})", type.spelling, left);
  static const std::vector<std::string> operators = {"+", "-", "*"};
  return fmt::format("{}({} {} {})", type.spelling, left, pick(operators), right);
}

std::string ExpressionGenerator::condition(int depth) {
  if (depth <= 0 || chance(20)) return fmt::format("({} & 1)", value(int_type(), depth - 1));
  static const std::vector<std::string> operators = {"<", ">", "<=", ">=", "==", "!="};
  Type type = any_type();
  if (type.kind == Kind::kNative && type.width == 1) type = int_type();
  if (chance(20))
    return fmt::format("({} {} {})", condition(depth - 1), chance(50) ? "&&" : "||", condition(depth - 1));
  return fmt::format("({} {} {})", value(type, depth - 1), pick(operators), value(type, depth - 1));
}

std::string ExpressionGenerator::value(const Type& type, int depth) {
  if (depth <= 0) return chance(75) ? variable_as(type, 0) : literal(type);
  if (chance(12))
    return fmt::format("({} ? {} : {})", condition(depth - 1), value(type, depth - 1),
                       value(type, depth - 1));
  if (chance(10) && !functions_.empty()) return call(type, depth);
  if (chance(15)) return variable_as(type, depth);
  switch (type.kind) {
    case Kind::kNative:
      return native_value(type, depth);
    case Kind::kInteger:
      return integer_value(type, depth);
    default:
      return fixed_value(type, depth);
  }
}

std::string ExpressionGenerator::call(const Type& type, int depth) {
  const Function function = pick(functions_);
  std::string arguments;
  for (const Type& parameter : function.parameters)
    arguments += (arguments.empty() ? "" : ", ") + value(parameter, depth - 2);
  return convert(fmt::format("{}({})", function.name, arguments), function.result, type);
}

}  // namespace hlsc::differential
