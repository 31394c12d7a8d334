/// Random types and expressions of the subset over the variables in scope.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace hlsc::differential {

enum class Kind { kNative, kInteger, kFixed };

/// A value type of the subset: a native integer, ap_[u]int<width> or ap_[u]fixed<width, whole, quantisation,
/// overflow>.
struct Type {
  Kind kind = Kind::kNative;
  int width = 32;
  bool is_signed = true;
  int whole = 0;
  std::string spelling;
};

struct Variable {
  std::string name;
  Type type;
  int elements = 0;  ///< 0: a scalar; else the length of an array, a power of two.
  bool writable = true;
  int columns = 0;          ///< Of a two-dimensional array, a power of two.
  std::string member = {};  ///< ".m0" for the member of a struct.
};

struct Function {
  std::string name;
  Type result;
  std::vector<Type> parameters;
};

/// Draws from one random sequence, so that a seed is a program.
class ExpressionGenerator {
 public:
  explicit ExpressionGenerator(std::uint64_t seed) : random_(seed) {}

 protected:
  // --- Choices ---
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool chance(int percent) { return below(100) < percent; }
  template <typename T>
  const T& pick(const std::vector<T>& from) {
    return from[below(static_cast<int>(from.size()))];
  }
  std::string fresh(const char* stem) { return fmt::format("{}{}", stem, counter_++); }

  Type native_type();
  Type integer_type() {
    int width = chance(85) ? between(1, 40) : between(41, 90);
    bool is_signed = chance(50);
    return {Kind::kInteger, width, is_signed, 0, fmt::format("ap_{}int<{}>", is_signed ? "" : "u", width)};
  }
  Type fixed_type();
  Type any_type() {
    int roll = below(100);
    return roll < 50 ? native_type() : roll < 85 ? integer_type() : fixed_type();
  }
  /// Types that may cross the top's border as scalars, array elements and stream tokens.
  Type port_type() { return chance(50) ? native_type() : integer_type(); }

  // --- Expressions ---
  std::string literal(const Type& type) {
    if (type.kind == Kind::kFixed) return fmt::format("{}({})", type.spelling, (below(512) - 256) / 16.0);
    int span = type.width >= 16 ? 60000 : 1 << std::min(type.width, 14);
    int value = type.is_signed ? below(span) - span / 2 : below(span);
    return fmt::format("{}({})", constructor(type), value);
  }
  /// A spelling that can be followed by `(`.
  static std::string constructor(const Type& type) {
    return type.kind == Kind::kNative ? "(" + type.spelling + ")" : type.spelling;
  }
  std::string index_into(int elements, int depth) {
    std::string index = depth > 0 ? value(native_type(), depth - 1) : plain_index();
    return fmt::format("[(unsigned)({}) & {}]", index, elements - 1);
  }
  /// A scalar in scope or a number: subscripts in subscripts have an end.
  std::string plain_index() {
    const Type type = native_type();
    if (scope_.empty() || chance(30)) return literal(type);
    const Variable v = pick(scope_);
    return v.elements ? literal(type) : convert(v.name + v.member, v.type, type);
  }
  std::string read(const Variable& v, int depth) {
    return v.name + (v.elements ? index_into(v.elements, depth) : "") +
           (v.columns ? index_into(v.columns, depth) : "") + v.member;
  }
  /// Any variable in scope, converted to `type`.
  std::string variable_as(const Type& type, int depth) {
    if (scope_.empty()) return literal(type);
    const Variable v = pick(scope_);
    return convert(read(v, depth), v.type, type);
  }
  static std::string convert(const std::string& text, const Type& from, const Type& to) {
    if (to.kind == Kind::kNative && from.kind != Kind::kNative)
      return fmt::format("({})({}).to_int64()", to.spelling, text);
    return fmt::format("{}({})", constructor(to), text);
  }
  std::string condition(int depth);
  static Type int_type() { return {Kind::kNative, 32, true, 0, "int"}; }

  std::string value(const Type& type, int depth);
  std::string call(const Type& type, int depth);
  std::string native_value(const Type& type, int depth);
  std::string integer_value(const Type& type, int depth);
  std::string fixed_value(const Type& type, int depth);

  std::mt19937_64 random_;
  int counter_ = 0;
  std::vector<Variable> scope_;
  std::vector<Function> functions_;
};

}  // namespace hlsc::differential
