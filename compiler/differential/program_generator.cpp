#include "program_generator.h"

#include "expression_generator.h"

namespace hlsc::differential {
namespace {

/// What a stream carries or an array channel holds: a value, or a struct of the program's own.
struct Token {
  Type type;
  bool is_struct = false;
  std::string spelling() const { return is_struct ? "Packet" : type.spelling; }
};

class Generator : ExpressionGenerator {
 public:
  using ExpressionGenerator::ExpressionGenerator;

  std::string program() {
    if (chance(45)) declare_packet();
    helpers();
    std::string body;
    std::string header = "// top: fuzz_top\n// calls: 4\n";
    switch (below(5)) {
      case 0:
        body = array_top();
        break;
      case 1:
        body = stream_top();
        break;
      case 2:
        body = dataflow_top();
        break;
      case 3:
        body = calls_top();
        header = "// top: fuzz_top\n// calls: 40\n// tokens: 1\n";
        break;
      default:
        body = scalar_top();
        break;
    }
    return header + "#include \"ap_fixed.h\"\n#include \"ap_int.h\"\n#include \"hls_stream.h\"\n\n" +
           struct_text_ + helper_text_ + body;
  }

 private:
  // --- Statements ---
  void line(const std::string& text) { text_ += std::string(2 * indent_, ' ') + text + "\n"; }

  /// The struct of the program: two or three members.
  void declare_packet() {
    struct_text_ = "struct Packet {\n";
    for (int n = between(2, 3); n > 0; --n) {
      members_.push_back(port_type());
      struct_text_ += fmt::format("  {} m{};\n", members_.back().spelling, members_.size() - 1);
    }
    struct_text_ += "};\n\n";
  }
  void put_members_in_scope(Variable v) {
    for (std::size_t i = 0; i < members_.size(); ++i) {
      v.type = members_[i];
      v.member = fmt::format(".m{}", i);
      scope_.push_back(v);
    }
  }
  std::string assigned_members(const std::string& target, int depth) {
    std::string text;
    for (std::size_t i = 0; i < members_.size(); ++i)
      text += fmt::format("{}{}.m{} = {};", i ? " " : "", target, i, value(members_[i], depth));
    return text;
  }
  void declare_struct() {
    Variable v{fresh("p"), {}, 0};
    line(fmt::format("Packet {};", v.name));
    line(assigned_members(v.name, 2));
    put_members_in_scope(v);
  }
  void declare_struct_array() {
    Variable v{fresh("q"), {}, 1 << between(1, 3)};
    line(fmt::format("Packet {}[{}];", v.name, v.elements));
    if (chance(60)) line(partition(v));
    std::string i = fresh("i"), element = fmt::format("{}[{}]", v.name, i);
    line(fmt::format("for (int {0} = 0; {0} < {1}; ++{0}) {{ {2} }}", i, v.elements,
                     assigned_members(element, 0)));
    put_members_in_scope(v);
    if (chance(50)) {  // A shift of whole structs.
      std::string k = fresh("i");
      line(fmt::format("for (int {0} = {1}; {0} > 0; --{0}) {2}[{0}] = {2}[{0} - 1];", k, v.elements - 1,
                       v.name));
    }
  }
  std::string partition(const Variable& v) {
    static const std::vector<std::string> kinds = {"complete", "complete", "cyclic factor=2",
                                                   "block factor=2", "cyclic factor=3"};
    std::string dim = v.columns ? fmt::format(" dim={}", below(3)) : "";
    return fmt::format("#pragma HLS ARRAY_PARTITION variable={} {}{}", v.name, pick(kinds), dim);
  }

  void declare() {
    if (!members_.empty() && chance(20)) return chance(50) ? declare_struct() : declare_struct_array();
    Variable v{fresh("v"), any_type(), 0};
    line(fmt::format("{} {} = {};", v.type.spelling, v.name, value(v.type, 2)));
    scope_.push_back(v);
  }
  void declare_array() {
    Variable v{fresh("a"), any_type(), 1 << between(1, 4)};
    if (chance(35)) v.columns = 1 << between(1, 3);
    bool is_static = chance(25);
    std::string dims = fmt::format("[{}]", v.elements) + (v.columns ? fmt::format("[{}]", v.columns) : "");
    line(fmt::format("{}{} {}{};", is_static ? "static " : "", v.type.spelling, v.name, dims));
    if (chance(60)) line(partition(v));
    if (!is_static || v.type.kind == Kind::kFixed) {
      std::string i = fresh("i"), k = fresh("i");
      std::string inner = v.columns ? fmt::format("for (int {0} = 0; {0} < {1}; ++{0}) ", k, v.columns) : "";
      line(fmt::format("for (int {0} = 0; {0} < {1}; ++{0}) {2}{3}[{0}]{4} = {5};", i, v.elements, inner,
                       v.name, v.columns ? "[" + k + "]" : "", literal(v.type)));
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
      line(fmt::format("{} = {};", target, value(v.type, between(1, 3))));
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
    bool was_in_loop = in_loop_;
    in_loop_ = false;  // A break would leave the switch.
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
    in_loop_ = was_in_loop;
  }
  /// The head of a loop that counts `i`, and what closes it.
  std::string open_loop(const std::string& i, int count) {
    int start = below(3), step = between(1, 2);
    if (chance(75)) {
      line(fmt::format("for (int {0} = {1}; {0} < {2}; {0} += {3}) {{", i, start, count, step));
      return "}";
    }
    line(fmt::format("int {} = {};", i, count));
    if (chance(60)) {
      line(fmt::format("while (--{} > {}) {{", i, start));
      return "}";
    }
    line("do {");
    return fmt::format("}} while (--{} > {});", i, start);
  }
  void loop_pragma(bool inner) {
    if (!inner) {
      if (chance(8)) line("#pragma HLS PIPELINE");  // Unrolls the loops inside.
    } else if (chance(60)) {
      line(chance(60)   ? "#pragma HLS PIPELINE"
           : chance(85) ? fmt::format("#pragma HLS PIPELINE II={}", between(1, 3))
                        : "#pragma HLS PIPELINE off");
    } else if (chance(40)) {
      line(chance(50) ? "#pragma HLS UNROLL" : fmt::format("#pragma HLS UNROLL factor={}", between(2, 3)));
    }
    if (chance(10)) line("#pragma HLS LOOP_TRIPCOUNT min=1 max=12");
  }
  void loop(int depth) {
    std::string i = fresh("i");
    std::size_t outer = scope_.size();
    bool inner = depth <= 1, was_in_loop = in_loop_;
    std::string end = open_loop(i, between(1, inner ? 12 : 6));
    loop_pragma(inner);
    scope_.push_back({i, int_type(), 0, false});
    in_loop_ = true;
    block(between(1, 3), inner ? 0 : depth - 1);
    if (chance(30)) leave_loop();
    if (chance(30)) {
      ++indent_;
      assign();
      --indent_;
    }
    in_loop_ = was_in_loop;
    scope_.resize(outer);
    line(end);
  }
  void leave_loop() { line(fmt::format("  if ({}) {};", condition(1), chance(50) ? "break" : "continue")); }
  void statement(int depth) {
    int roll = below(100);
    if (in_loop_ && chance(6))
      leave_loop();
    else if (!procedures_.empty() && chance(8))
      call_procedure();
    else if (roll < 22)
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

  // --- Functions and tops ---
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
    if (chance(35)) procedure();
    text_.clear();
    scope_.clear();
    indent_ = 1;
  }
  /// A function that changes an array and a scalar of its caller.
  void procedure() {
    Procedure made{
        fresh("procedure"), {fresh("x"), any_type(), 1 << between(1, 4)}, {fresh("y"), any_type(), 0}};
    scope_ = {made.array, made.scalar};
    text_ = fmt::format("static void {}({} {}[{}], {}& {}) {{\n", made.name, made.array.type.spelling,
                        made.array.name, made.array.elements, made.scalar.type.spelling, made.scalar.name);
    if (chance(30)) text_ += partition(made.array) + "\n";
    indent_ = 1;
    loop(1);
    assign();
    helper_text_ += text_ + "}\n\n";
    procedures_.push_back(made);
  }
  /// Calls it with an array of its own, twice at times.
  void call_procedure() {
    const Procedure called = pick(procedures_);
    Variable array{fresh("a"), called.array.type, called.array.elements};
    Variable scalar{fresh("v"), called.scalar.type, 0};
    line(fmt::format("{} {}[{}];", array.type.spelling, array.name, array.elements));
    std::string i = fresh("i");
    line(fmt::format("for (int {0} = 0; {0} < {1}; ++{0}) {2}[{0}] = {3};", i, array.elements, array.name,
                     value(array.type, 1)));
    line(fmt::format("{} {} = {};", scalar.type.spelling, scalar.name, value(scalar.type, 1)));
    for (int n = between(1, 2); n > 0; --n)
      line(fmt::format("{}({}, {});", called.name, array.name, scalar.name));
    scope_.push_back(array);
    scope_.push_back(scalar);
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
  void overlap_calls() { line(fmt::format("#pragma HLS PIPELINE II={}", between(1, 3))); }
  std::string scalar_top() {
    Type result = port_type();
    std::string parameters = scalar_parameters(between(1, 4));
    if (chance(30)) overlap_calls();
    prologue();
    for (int n = between(2, 6); n > 0; --n) statement(2);
    line(fmt::format("return {};", value(result, 3)));
    return fmt::format("{} fuzz_top({}) {{\n{}}}\n", result.spelling, parameters, text_);
  }
  std::string array_top() {
    std::string parameters = scalar_parameters(between(0, 2));
    auto add = [&](const char* stem, bool writable) {
      Variable v{fresh(stem), port_type(), 1 << between(2, 5), writable};
      bool is_struct = !members_.empty() && chance(35);
      if (!is_struct && chance(25)) v.columns = 1 << between(1, 2);
      parameters += fmt::format("{}{}{} {}[{}]{}", parameters.empty() ? "" : ", ", writable ? "" : "const ",
                                is_struct ? "Packet" : v.type.spelling, v.name, v.elements,
                                v.columns ? fmt::format("[{}]", v.columns) : "");
      is_struct ? put_members_in_scope(v) : scope_.push_back(v);
    };
    add("x", false);
    add("y", true);
    if (chance(40)) add("z", true);
    Type result = port_type();
    if (chance(15)) overlap_calls();
    prologue();
    for (int n = between(2, 5); n > 0; --n) chance(50) ? loop(2) : statement(2);
    line(fmt::format("return {};", value(result, 2)));
    return fmt::format("{} fuzz_top({}) {{\n{}}}\n", result.spelling, parameters, text_);
  }
  Token token() { return {port_type(), !members_.empty() && chance(40)}; }
  std::string stream(const Token& token, const std::string& name) {
    return fmt::format("hls::stream<{} >& {}", token.spelling(), name);
  }
  void write_token(const std::string& guard, const std::string& out, const Token& token, int depth) {
    if (!token.is_struct) return line(fmt::format("{}{}{});", guard, out, value(token.type, depth)));
    std::string packet = fresh("w");
    line(fmt::format("Packet {};", packet));
    line(assigned_members(packet, depth - 1));
    line(fmt::format("{}{}{});", guard, out, packet));
  }

  /// A loop over `tokens` tokens: `in` is an expression that takes one, `out` a call or an assignment up to
  /// its value; INDEX in them stands for the counter. Unless `exactly_one`, writes may fall out or come
  /// twice.
  void token_loop(std::string in, const Token& in_token, std::string out, const Token& out_token, int tokens,
                  bool exactly_one) {
    std::string i = fresh("i"), name = fresh("t");
    for (std::string* text : {&in, &out})
      if (std::size_t at = text->find("INDEX"); at != std::string::npos) text->replace(at, 5, i);
    line(fmt::format("for (int {0} = 0; {0} < {1}; ++{0}) {{", i, tokens));
    line(chance(60) ? "#pragma HLS PIPELINE II=1" : "#pragma HLS PIPELINE");
    ++indent_;
    std::size_t outer = scope_.size();
    line(fmt::format("{} {} = {};", in_token.spelling(), name, in));
    in_token.is_struct ? put_members_in_scope({name, {}, 0}) : scope_.push_back({name, in_token.type, 0});
    scope_.push_back({i, int_type(), 0, false});
    for (int n = between(0, 3); n > 0; --n) statement(0);
    bool is_guarded = !exactly_one && chance(40);
    write_token(is_guarded ? fmt::format("if ({}) ", condition(2)) : "", out, out_token, 2);
    if (!exactly_one && chance(20)) write_token("", out, out_token, 1);
    scope_.resize(outer);
    --indent_;
    line("}");
  }
  std::string stream_top() {
    Token in = token(), out = token();
    std::string scalars = scalar_parameters(between(0, 2));
    prologue();
    token_loop("source.read()", in, "sink.write(", out, between(1, 40), false);
    if (chance(40)) {
      statement(2);
      token_loop("source.read()", in, "sink.write(", out, between(1, 20), false);
    }
    return fmt::format("void fuzz_top({}, {}{}{}) {{\n{}}}\n", stream(in, "source"), stream(out, "sink"),
                       scalars.empty() ? "" : ", ", scalars, text_);
  }

  /// A top whose calls overlap: each takes a token, at times one of another stream, and may give some.
  std::string calls_top() {
    Token in = token(), more = token(), out = token();
    bool has_more = chance(40);
    if (chance(70)) line("#pragma HLS INTERFACE ap_ctrl_none port=return");
    overlap_calls();
    for (int n = between(1, 3); n > 0; --n) declare_static();
    if (chance(50)) declare_array();
    auto take = [&](const Token& token, const char* stream, const std::string& guard) {
      std::string name = fresh("t");
      line(fmt::format("{} {}{};", token.spelling(), name, guard.empty() ? "" : " = {}"));
      line(fmt::format("{}{} = {}.read();", guard, name, stream));
      token.is_struct ? put_members_in_scope({name, {}, 0}) : scope_.push_back({name, token.type, 0});
    };
    take(in, "source", "");
    for (int n = between(1, 4); n > 0; --n) statement(1);
    if (chance(30)) write_token("", "sink.write(", out, 1);
    if (has_more) take(more, "extra", chance(60) ? fmt::format("if ({}) ", condition(2)) : "");
    for (int n = between(0, 3); n > 0; --n) statement(1);
    write_token(chance(40) ? fmt::format("if ({}) ", condition(2)) : "", "sink.write(", out, 2);
    return fmt::format("void fuzz_top({}, {}{}) {{\n{}}}\n", stream(in, "source"),
                       has_more ? stream(more, "extra") + ", " : "", stream(out, "sink"), text_);
  }

  /// Between two processes: a stream, or an array that one fills and the other reads.
  struct Channel {
    Token token;
    bool is_array = false;
  };
  std::string stage(int number, const Channel& in, const Channel& out, int tokens) {
    scope_.clear();
    text_.clear();
    scope_.push_back({"gain", int_type(), 0, false});
    prologue();
    token_loop(in.is_array ? "in[INDEX]" : "in.read()", in.token,
               out.is_array ? "out[INDEX] = (" : "out.write(", out.token, tokens, true);
    auto parameter = [&](const Channel& channel, const char* name) {
      return channel.is_array ? fmt::format("{} {}[{}]", channel.token.spelling(), name, tokens)
                              : stream(channel.token, name);
    };
    return fmt::format("static void stage{}({}, {}, int gain) {{\n{}}}\n\n", number, parameter(in, "in"),
                       parameter(out, "out"), text_);
  }
  std::string dataflow_top() {
    int stages = between(2, 4), tokens = between(1, 30);
    std::string stage_text, body = "#pragma HLS DATAFLOW\n";
    functions_.clear();  // A helper that is shared by two processes would be no process of its own.
    procedures_.clear();
    helper_text_.clear();
    std::vector<Channel> channels;
    for (int i = 0; i <= stages; ++i) {
      bool is_inside = i > 0 && i < stages;
      channels.push_back({token(), is_inside && chance(25)});
      if (channels.back().is_array) channels.back().token.is_struct = false;
      if (!is_inside) continue;
      std::string type = channels[i].token.spelling();
      if (channels[i].is_array) {
        body += fmt::format("  {} channel{}[{}];\n", type, i, tokens);
        continue;
      }
      body += fmt::format("  hls::stream<{} > channel{};\n", type, i);
      if (chance(50))
        body += fmt::format("#pragma HLS STREAM variable=channel{} depth={}\n", i, between(1, 9));
    }
    auto name = [&](int i) {
      return i == 0 ? "source" : i == stages ? std::string("sink") : fmt::format("channel{}", i);
    };
    for (int s = 0; s < stages; ++s) {
      stage_text += stage(s, channels[s], channels[s + 1], tokens);
      body += fmt::format("  stage{}({}, {}, gain);\n", s, name(s), name(s + 1));
    }
    return stage_text + fmt::format("void fuzz_top({}, {}, int gain) {{\n{}}}\n",
                                    stream(channels.front().token, "source"),
                                    stream(channels.back().token, "sink"), body);
  }

  struct Procedure {
    std::string name;
    Variable array, scalar;  ///< Its parameters.
  };
  int indent_ = 1;
  bool in_loop_ = false;       ///< break and continue have a meaning here.
  std::vector<Type> members_;  ///< Of Packet; empty without it.
  std::vector<Procedure> procedures_;
  std::string text_, helper_text_, struct_text_;
};

}  // namespace

std::string generate_program(std::uint64_t seed) { return Generator(seed).program(); }

}  // namespace hlsc::differential
