#include "program_generator.h"

#include <fmt/format.h>

#include <random>
#include <vector>

namespace hlsc::differential {
namespace {

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
};

struct Function {
  std::string name;
  Type result;
  std::vector<Type> parameters;
};

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : random_(seed) {}

  std::string program() {
    helpers();
    std::string body;
    switch (below(4)) {
      case 0:
        body = array_top();
        break;
      case 1:
        body = stream_top();
        break;
      case 2:
        body = dataflow_top();
        break;
      default:
        body = scalar_top();
        break;
    }
    std::string header = "// top: fuzz_top\n// calls: 4\n";
    return header + "#include \"ap_fixed.h\"\n#include \"ap_int.h\"\n#include \"hls_stream.h\"\n\n" +
           helper_text_ + body;
  }

 private:
  // --- Choices
  // -------------------------------------------------------------------------------------------------
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool chance(int percent) { return below(100) < percent; }
  template <typename T>
  const T& pick(const std::vector<T>& from) {
    return from[below(static_cast<int>(from.size()))];
  }
  std::string fresh(const char* stem) { return fmt::format("{}{}", stem, counter_++); }

  Type native_type() {
    static const std::vector<Type> types = {
        {Kind::kNative, 8, true, 0, "signed char"}, {Kind::kNative, 8, false, 0, "unsigned char"},
        {Kind::kNative, 16, true, 0, "short"},      {Kind::kNative, 16, false, 0, "unsigned short"},
        {Kind::kNative, 32, true, 0, "int"},        {Kind::kNative, 32, false, 0, "unsigned"},
        {Kind::kNative, 64, true, 0, "long long"},  {Kind::kNative, 64, false, 0, "unsigned long long"},
        {Kind::kNative, 1, false, 0, "bool"},       {Kind::kNative, 32, true, 0, "int"}};
    return pick(types);
  }
  Type integer_type() {
    int width = chance(85) ? between(1, 40) : between(41, 90);
    bool is_signed = chance(50);
    return {Kind::kInteger, width, is_signed, 0, fmt::format("ap_{}int<{}>", is_signed ? "" : "u", width)};
  }
  Type fixed_type() {
    static const std::vector<std::string> quantisation = {
        "AP_TRN", "AP_RND", "AP_TRN_ZERO", "AP_RND_ZERO", "AP_RND_MIN_INF", "AP_RND_INF", "AP_RND_CONV"};
    static const std::vector<std::string> overflow = {"AP_WRAP", "AP_SAT", "AP_SAT_ZERO", "AP_SAT_SYM"};
    int width = between(2, 28), whole = between(-2, width + 2);
    bool is_signed = chance(60);
    return {Kind::kFixed, width, is_signed, whole,
            fmt::format("ap_{}fixed<{}, {}, {}, {}>", is_signed ? "" : "u", width, whole, pick(quantisation),
                        pick(overflow))};
  }
  Type any_type() {
    int roll = below(100);
    return roll < 50 ? native_type() : roll < 85 ? integer_type() : fixed_type();
  }
  /// Types that may cross the top's border as scalars, array elements and stream tokens.
  Type port_type() { return chance(50) ? native_type() : integer_type(); }

  // --- Expressions
  // ---------------------------------------------------------------------------------------------
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
  std::string index_into(const Variable& array, int depth) {
    return fmt::format("(unsigned)({}) & {}", value(native_type(), depth - 1), array.elements - 1);
  }
  std::string read(const Variable& v, int depth) {
    return v.elements ? fmt::format("{}[{}]", v.name, index_into(v, depth)) : v.name;
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
  std::string condition(int depth) {
    if (depth <= 0 || chance(20)) return fmt::format("({} & 1)", value(int_type(), depth - 1));
    static const std::vector<std::string> operators = {"<", ">", "<=", ">=", "==", "!="};
    Type type = any_type();
    if (type.kind == Kind::kNative && type.width == 1) type = int_type();
    if (chance(20))
      return fmt::format("({} {} {})", condition(depth - 1), chance(50) ? "&&" : "||", condition(depth - 1));
    return fmt::format("({} {} {})", value(type, depth - 1), pick(operators), value(type, depth - 1));
  }
  static Type int_type() { return {Kind::kNative, 32, true, 0, "int"}; }

  std::string value(const Type& type, int depth) {
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
  std::string call(const Type& type, int depth) {
    const Function function = pick(functions_);
    std::string arguments;
    for (const Type& parameter : function.parameters)
      arguments += (arguments.empty() ? "" : ", ") + value(parameter, depth - 2);
    return convert(fmt::format("{}({})", function.name, arguments), function.result, type);
  }
  std::string native_value(const Type& type, int depth) {
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
        return fmt::format("({})({} % {})", type.spelling, value(int_type(), depth - 1),
                           chance(50) ? -7 : 11);
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
  std::string integer_value(const Type& type, int depth) {
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
  std::string fixed_value(const Type& type, int depth) {
    Type a = fixed_type(), b = fixed_type();
    std::string left = value(a, depth - 1), right = value(b, depth - 1);
    if (chance(15)) return fmt::format("{}({})", type.spelling, value(integer_type(), depth - 1));
    if (chance(10)) return fmt::format("{}(-{})", type.spelling, left);
    static const std::vector<std::string> operators = {"+", "-", "*"};
    return fmt::format("{}({} {} {})", type.spelling, left, pick(operators), right);
  }

  // --- Statements
  // ----------------------------------------------------------------------------------------------
  void line(const std::string& text) { text_ += std::string(2 * indent_, ' ') + text + "\n"; }

  void declare() {
    Variable v{fresh("v"), any_type(), 0};
    line(fmt::format("{} {} = {};", v.type.spelling, v.name, value(v.type, 2)));
    scope_.push_back(v);
  }
  void declare_array() {
    Variable v{fresh("a"), any_type(), 1 << between(1, 4)};
    bool is_static = chance(25);
    line(fmt::format("{}{} {}[{}];", is_static ? "static " : "", v.type.spelling, v.name, v.elements));
    if (chance(40))
      line(fmt::format("#pragma HLS ARRAY_PARTITION variable={} complete", v.name));
    else if (chance(20))
      line(fmt::format("#pragma HLS ARRAY_PARTITION variable={} cyclic factor=2", v.name));
    if (!is_static || v.type.kind == Kind::kFixed) {
      std::string i = fresh("i");
      line(fmt::format("for (int {0} = 0; {0} < {1}; ++{0}) {2}[{0}] = {3};", i, v.elements, v.name,
                       literal(v.type)));
    }
    scope_.push_back(v);
  }
  void declare_static() {
    Variable v{fresh("s"), native_type(), 0};
    line(fmt::format("static {} {} = {};", v.type.spelling, v.name, below(50)));
    scope_.push_back(v);
  }
  void assign() {
    std::vector<Variable> targets;
    for (const Variable& v : scope_)
      if (v.writable) targets.push_back(v);
    if (targets.empty()) return declare();
    const Variable v = pick(targets);
    std::string target = read(v, 2);
    static const std::vector<std::string> compound = {"+=", "-=", "^=", "|=", "&="};
    if (v.type.kind != Kind::kFixed && v.type.width > 1 && chance(30))
      line(fmt::format("{} {} {};", target, pick(compound), value(v.type, 2)));
    else
      line(fmt::format("{} = {};", target, value(v.type, 3)));
  }
  void block(int statements, int depth) {
    std::size_t outer = scope_.size();
    ++indent_;
    for (int i = 0; i < statements; ++i) statement(depth);
    --indent_;
    scope_.resize(outer);
  }
  void branch(int depth) {
    line(fmt::format("if ({}) {{", condition(2)));
    block(between(1, 3), depth - 1);
    if (chance(50)) {
      line("} else {");
      block(between(1, 2), depth - 1);
    }
    line("}");
  }
  void selection(int depth) {
    line(fmt::format("switch ((unsigned)({}) & 3) {{", value(int_type(), 2)));
    for (int label = 0; label < 3; ++label) {
      line(fmt::format("  case {}: {{", label));
      block(1, depth - 1);
      line(chance(80) ? "  } break;" : "  }  // fall through");
    }
    line("  default: {");
    block(1, depth - 1);
    line("  }");
    line("}");
  }
  void loop(int depth) {
    std::string i = fresh("i");
    int count = between(1, 12);
    bool inner = depth <= 1;
    line(fmt::format("for (int {0} = {1}; {0} < {2}; {0} += {3}) {{", i, below(3), count, between(1, 2)));
    if (inner && chance(60))
      line(chance(70) ? "#pragma HLS PIPELINE" : fmt::format("#pragma HLS PIPELINE II={}", between(1, 3)));
    else if (inner && chance(40))
      line(chance(50) ? "#pragma HLS UNROLL" : fmt::format("#pragma HLS UNROLL factor={}", between(2, 3)));
    scope_.push_back({i, int_type(), 0, false});
    block(between(1, 3), inner ? 0 : depth - 1);
    if (chance(20)) line(fmt::format("  if ({}) {};", condition(1), chance(50) ? "break" : "continue"));
    if (chance(30)) {
      ++indent_;
      assign();
      --indent_;
    }
    scope_.pop_back();
    line("}");
  }
  void statement(int depth) {
    int roll = below(100);
    if (roll < 22)
      declare();
    else if (roll < 62 || depth <= 0)
      assign();
    else if (roll < 78)
      branch(depth);
    else if (roll < 84)
      selection(depth);
    else
      loop(depth);
  }

  // --- Functions and tops
  // --------------------------------------------------------------------------------------
  void helpers() {
    for (int n = below(3); n > 0; --n) {
      Function function{fresh("helper"), any_type(), {}};
      std::string parameters;
      scope_.clear();
      for (int i = between(1, 3); i > 0; --i) {
        Variable v{fresh("p"), any_type(), 0};
        parameters += (parameters.empty() ? "" : ", ") + v.type.spelling + " " + v.name;
        function.parameters.push_back(v.type);
        scope_.push_back(v);
      }
      text_ = fmt::format("static {} {}({}) {{\n", function.result.spelling, function.name, parameters);
      if (chance(30)) text_ += "#pragma HLS INLINE off\n";
      indent_ = 1;
      for (int i = between(1, 3); i > 0; --i) statement(1);
      line(fmt::format("return {};", value(function.result, 2)));
      helper_text_ += text_ + "}\n\n";
      functions_.push_back(function);
    }
    text_.clear();
    scope_.clear();
    indent_ = 1;
  }
  void prologue() {
    for (int n = between(1, 3); n > 0; --n) declare();
    if (chance(40)) declare_static();
    if (chance(50)) declare_array();
  }
  std::string scalar_parameters(int count) {
    std::string parameters;
    for (int i = 0; i < count; ++i) {
      Variable v{fresh("in"), port_type(), 0, false};
      parameters += (parameters.empty() ? "" : ", ") + v.type.spelling + " " + v.name;
      scope_.push_back(v);
    }
    return parameters;
  }
  std::string scalar_top() {
    Type result = port_type();
    std::string parameters = scalar_parameters(between(1, 4));
    prologue();
    for (int n = between(2, 6); n > 0; --n) statement(2);
    line(fmt::format("return {};", value(result, 3)));
    return fmt::format("{} fuzz_top({}) {{\n{}}}\n", result.spelling, parameters, text_);
  }
  std::string array_top() {
    std::string parameters = scalar_parameters(between(0, 2));
    auto add = [&](const char* stem, bool writable) {
      Variable v{fresh(stem), port_type(), 1 << between(2, 5), writable};
      parameters += fmt::format("{}{}{} {}[{}]", parameters.empty() ? "" : ", ", writable ? "" : "const ",
                                v.type.spelling, v.name, v.elements);
      scope_.push_back(v);
    };
    add("x", false);
    add("y", true);
    if (chance(40)) add("z", true);
    Type result = port_type();
    prologue();
    for (int n = between(2, 5); n > 0; --n) chance(50) ? loop(2) : statement(2);
    line(fmt::format("return {};", value(result, 2)));
    return fmt::format("{} fuzz_top({}) {{\n{}}}\n", result.spelling, parameters, text_);
  }
  /// The body of a loop over stream tokens: reads into a fresh variable, some work, guarded writes.
  void stream_loop(const std::string& in, const Type& in_type, const std::string& out, const Type& out_type,
                   int tokens, bool exactly_one) {
    std::string i = fresh("i"), token = fresh("t");
    line(fmt::format("for (int {0} = 0; {0} < {1}; ++{0}) {{", i, tokens));
    line(chance(60) ? "#pragma HLS PIPELINE II=1" : "#pragma HLS PIPELINE");
    ++indent_;
    line(fmt::format("{} {} = {}.read();", in_type.spelling, token, in));
    std::size_t outer = scope_.size();
    scope_.push_back({token, in_type, 0});
    scope_.push_back({i, int_type(), 0, false});
    for (int n = between(0, 3); n > 0; --n) statement(0);
    if (!exactly_one && chance(40))
      line(fmt::format("if ({}) {}.write({});", condition(2), out, value(out_type, 2)));
    else
      line(fmt::format("{}.write({});", out, value(out_type, 2)));
    if (!exactly_one && chance(20)) line(fmt::format("{}.write({});", out, value(out_type, 1)));
    scope_.resize(outer);
    --indent_;
    line("}");
  }
  std::string stream_top() {
    Type in = port_type(), out = port_type();
    std::string scalars = scalar_parameters(between(0, 2));
    prologue();
    stream_loop("source", in, "sink", out, between(1, 40), false);
    if (chance(40)) {
      statement(2);
      stream_loop("source", in, "sink", out, between(1, 20), false);
    }
    return fmt::format("void fuzz_top(hls::stream<{} >& source, hls::stream<{} >& sink{}{}) {{\n{}}}\n",
                       in.spelling, out.spelling, scalars.empty() ? "" : ", ", scalars, text_);
  }
  std::string dataflow_top() {
    int stages = between(2, 4), tokens = between(1, 30);
    std::vector<Type> types;
    for (int i = 0; i <= stages; ++i) types.push_back(port_type());
    std::string stage_text, body = "#pragma HLS DATAFLOW\n";
    functions_.clear();  // A helper that is shared by two processes would be no process of its own.
    helper_text_.clear();
    for (int s = 0; s < stages; ++s) {
      scope_.clear();
      text_.clear();
      scope_.push_back({"gain", int_type(), 0, false});
      prologue();
      stream_loop("in", types[s], "out", types[s + 1], tokens, true);
      stage_text += fmt::format(
          "static void stage{}(hls::stream<{} >& in, hls::stream<{} >& out, int gain) {{\n{}}}\n\n", s,
          types[s].spelling, types[s + 1].spelling, text_);
      if (s + 1 < stages) {
        body += fmt::format("  hls::stream<{} > channel{};\n", types[s + 1].spelling, s);
        if (chance(50))
          body += fmt::format("#pragma HLS STREAM variable=channel{} depth={}\n", s, between(1, 9));
      }
    }
    for (int s = 0; s < stages; ++s)
      body +=
          fmt::format("  stage{}({}, {}, gain);\n", s, s == 0 ? "source" : fmt::format("channel{}", s - 1),
                      s + 1 == stages ? "sink" : fmt::format("channel{}", s));
    return stage_text +
           fmt::format("void fuzz_top(hls::stream<{} >& source, hls::stream<{} >& sink, int gain) {{\n{}}}\n",
                       types.front().spelling, types.back().spelling, body);
  }

  std::mt19937_64 random_;
  int counter_ = 0;
  int indent_ = 1;
  std::vector<Variable> scope_;
  std::vector<Function> functions_;
  std::string text_, helper_text_;
};

}  // namespace

std::string generate_program(std::uint64_t seed) { return Generator(seed).program(); }

}  // namespace hlsc::differential
