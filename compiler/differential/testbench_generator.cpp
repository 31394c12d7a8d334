#include "testbench_generator.h"

#include <clang-c/Index.h>
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <regex>
#include <set>
#include <stdexcept>

namespace hlsc::differential {
namespace {

/// What every test bench begins with: random filling and printing of native and ap types.
constexpr const char* kPrelude = R"(
#include <cstdio>
#include <random>
#include "ap_fixed.h"
#include "ap_int.h"
#include "hls_stream.h"

namespace testbench {
std::mt19937_64 generator;

/// Half of the values are uniform bits, the others small, extreme or zero.
inline unsigned long long bits() {
  unsigned long long v = generator();
  switch (generator() % 8) {
    case 0: return v & 15;
    case 1: return ~(v & 7);
    case 2: return 0;
    case 3: return 1ull << (v & 63);
    default: return v;
  }
}
template <typename T> inline void fill_native(T& v) { v = static_cast<T>(bits()); }
inline void fill(bool& v) { v = bits() & 1; }
inline void fill(char& v) { fill_native(v); }
inline void fill(signed char& v) { fill_native(v); }
inline void fill(unsigned char& v) { fill_native(v); }
inline void fill(short& v) { fill_native(v); }
inline void fill(unsigned short& v) { fill_native(v); }
inline void fill(int& v) { fill_native(v); }
inline void fill(unsigned& v) { fill_native(v); }
inline void fill(long& v) { fill_native(v); }
inline void fill(unsigned long& v) { fill_native(v); }
inline void fill(long long& v) { fill_native(v); }
inline void fill(unsigned long long& v) { fill_native(v); }
template <int W> inline void fill_bits(ap_uint<W>& v) {
  v = 0;
  for (int i = 0; i < W; i += 64) v = (v << 64) | ap_uint<W>(bits());
}
template <> inline void fill_bits<1>(ap_uint<1>& v) { v = bits() & 1; }
template <int W> inline void fill(ap_uint<W>& v) { fill_bits(v); }
template <int W> inline void fill(ap_int<W>& v) {
  ap_uint<W> u;
  fill_bits(u);
  v = u;
}
template <int W, int I, ap_q_mode Q, ap_o_mode O, int N> inline void fill(ap_fixed<W, I, Q, O, N>& v) {
  ap_uint<W> u;
  fill_bits(u);
  v.range(W - 1, 0) = u;
}
template <int W, int I, ap_q_mode Q, ap_o_mode O, int N> inline void fill(ap_ufixed<W, I, Q, O, N>& v) {
  ap_uint<W> u;
  fill_bits(u);
  v.range(W - 1, 0) = u;
}
inline void show(long long v) { std::printf(" %lld", v); }
template <int W> inline void show(const ap_uint<W>& v) {
  std::printf(" ");
  for (int i = (W - 1) / 32 * 32; i >= 0; i -= 32) std::printf("%08x", (unsigned)(ap_uint<W>(v >> i)).to_uint64());
}
template <int W> inline void show(const ap_int<W>& v) { show(ap_uint<W>(v)); }
template <int W, int I, ap_q_mode Q, ap_o_mode O, int N> inline void show(const ap_fixed<W, I, Q, O, N>& v) {
  ap_fixed<W, I, Q, O, N> copy = v;
  show(ap_uint<W>(copy.range(W - 1, 0)));
}
template <int W, int I, ap_q_mode Q, ap_o_mode O, int N> inline void show(const ap_ufixed<W, I, Q, O, N>& v) {
  ap_ufixed<W, I, Q, O, N> copy = v;
  show(ap_uint<W>(copy.range(W - 1, 0)));
}
)";

std::string text_of(CXString string) {
  const char* c = clang_getCString(string);
  std::string text = c ? c : "";
  clang_disposeString(string);
  return text;
}
std::string spelling(CXCursor cursor) { return text_of(clang_getCursorSpelling(cursor)); }
std::string spelling(CXType type) { return text_of(clang_getTypeSpelling(type)); }

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file)
    throw std::runtime_error(fmt::format("cannot read {}; give the path of a kernel.", path.string()));
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Calls `visit` for each child of `parent`, whose visitor returns CXChildVisitResult.
template <typename Visit>
void for_children(CXCursor parent, Visit visit) {
  clang_visitChildren(
      parent, [](CXCursor child, CXCursor, CXClientData data) { return (*static_cast<Visit*>(data))(child); },
      &visit);
}

bool is_library_type(const std::string& name) {
  return name.rfind("ap_int", 0) == 0 || name.rfind("ap_uint", 0) == 0 || name.rfind("ap_fixed", 0) == 0 ||
         name.rfind("ap_ufixed", 0) == 0;
}

class Testbench {
 public:
  Testbench(const std::filesystem::path& kernel, Steering steering)
      : steering_(std::move(steering)), text_(read_file(kernel)) {}

  std::string generate(CXTranslationUnit unit, std::uint64_t seed) {
    find_top(clang_getTranslationUnitCursor(unit));
    for (int i = 0; i < clang_Cursor_getNumArguments(top_); ++i) argument(clang_Cursor_getArgument(top_, i));
    std::string call = fmt::format("{}({})", steering_.top, arguments_);
    if (CXType result = clang_getCursorResultType(top_); clang_getCanonicalType(result).kind != CXType_Void) {
      records(result);
      call = fmt::format("{} result = {};\n    testbench::show(result)", spelling(result), call);
    }
    return text_without_body() + kPrelude + record_functions_ + "}  // namespace testbench\n\n" +
           fmt::format(
               "int main() {{\n  testbench::generator.seed({});\n{}  for (int call = 0; call < {}; ++call) "
               "{{\n{}    {};\n{}"
               "    std::printf(\"\\n\");\n  }}\n  return 0;\n}}\n",
               seed, declarations_, steering_.calls, filling_, call, printing_);
  }

 private:
  void find_top(CXCursor root) {
    bool found = false;
    for_children(root, [&](CXCursor cursor) {
      if (clang_getCursorKind(cursor) == CXCursor_FunctionDecl && spelling(cursor) == steering_.top &&
          clang_isCursorDefinition(cursor)) {
        top_ = cursor;
        found = true;
      }
      return clang_getCursorKind(cursor) == CXCursor_LinkageSpec ||
                     clang_getCursorKind(cursor) == CXCursor_Namespace
                 ? CXChildVisit_Recurse
                 : CXChildVisit_Continue;
    });
    if (!found)
      throw std::runtime_error(fmt::format("there is no function {} in the kernel.", steering_.top));
  }

  std::string text_without_body() const {
    unsigned begin = 0, end = 0;
    for_children(top_, [&](CXCursor child) {
      if (clang_getCursorKind(child) == CXCursor_CompoundStmt) {
        CXSourceRange extent = clang_getCursorExtent(child);
        clang_getSpellingLocation(clang_getRangeStart(extent), nullptr, nullptr, nullptr, &begin);
        clang_getSpellingLocation(clang_getRangeEnd(extent), nullptr, nullptr, nullptr, &end);
      }
      return CXChildVisit_Continue;
    });
    return text_.substr(0, begin) + ";" + text_.substr(end);
  }

  /// Emits fill() and show() for a struct of the kernel, its members first.
  void records(CXType type) {
    CXType canonical = clang_getCanonicalType(type);
    std::string name = spelling(clang_getUnqualifiedType(canonical));
    if (canonical.kind != CXType_Record || is_library_type(name) || !known_records_.insert(name).second)
      return;
    std::string fills, shows;
    for_children(clang_getTypeDeclaration(canonical), [&](CXCursor member) {
      if (clang_getCursorKind(member) == CXCursor_FieldDecl) {
        records(clang_getCursorType(member));
        fills += fmt::format(" fill(v.{});", spelling(member));
        shows += fmt::format(" show(v.{});", spelling(member));
      }
      return CXChildVisit_Continue;
    });
    record_functions_ += fmt::format(
        "inline void fill({0}& v) {{{1} }}\ninline void show(const {0}& v) {{{2} }}\n", name, fills, shows);
  }

  void argument(CXCursor cursor) {
    CXType type = clang_getCursorType(cursor);
    std::string name = spelling(cursor);
    arguments_ += (arguments_.empty() ? "" : ", ");
    CXType target = type;
    if (type.kind == CXType_LValueReference) target = clang_getPointeeType(type);
    std::string target_name = spelling(clang_getCanonicalType(target));
    std::smatch match;
    if (std::regex_match(target_name, match, std::regex("hls::stream<(.*?)(, \\d+)?>")))
      return stream(name, target, 0);
    if (CXType element = pointee(cursor, type); element.kind != CXType_Invalid) {
      if (spelling(clang_getCanonicalType(element)).rfind("hls::stream<", 0) == 0)
        return stream(name, element, elements(cursor));
      return array(name, cursor, element);
    }
    records(target);
    std::string plain = spelling(clang_getUnqualifiedType(target));
    declarations_ += fmt::format("  {} {}{{}};\n", plain, name);
    filling_ += fill_scalar(name, plain);
    arguments_ += name;
    if (type.kind == CXType_LValueReference && !clang_isConstQualifiedType(target))
      printing_ += fmt::format("    testbench::show({});\n", name);
  }

  std::string fill_scalar(const std::string& name, const std::string& type) const {
    for (const auto& [ranged, range] : steering_.ranges)
      if (ranged == name)
        return fmt::format("    {} = ({})({} + (long long)(testbench::generator() % {}ull));\n", name, type,
                           range.low, range.high - range.low + 1);
    return fmt::format("    testbench::fill({});\n", name);
  }

  static CXType pointee(CXCursor cursor, CXType type) {
    // An array parameter decays to a pointer in its type; the cursor's spelling keeps the array.
    if (type.kind == CXType_Pointer) return clang_getPointeeType(type);
    if (type.kind == CXType_ConstantArray || type.kind == CXType_IncompleteArray)
      return clang_getArrayElementType(type);
    (void)cursor;
    return CXType{CXType_Invalid, {nullptr, nullptr}};
  }
  /// The first dimension written in the source, or 1.
  int elements(CXCursor cursor) const {
    CXSourceRange extent = clang_getCursorExtent(cursor);
    unsigned begin = 0, end = 0;
    clang_getSpellingLocation(clang_getRangeStart(extent), nullptr, nullptr, nullptr, &begin);
    clang_getSpellingLocation(clang_getRangeEnd(extent), nullptr, nullptr, nullptr, &end);
    std::smatch match;
    std::string source = text_.substr(begin, end - begin);
    return std::regex_search(source, match, std::regex("\\[\\s*(\\d+)\\s*\\]")) ? std::stoi(match[1]) : 1;
  }

  void array(const std::string& name, CXCursor cursor, CXType element) {
    std::string dimensions = fmt::format("[{}]", elements(cursor));
    bool is_const = clang_isConstQualifiedType(element);
    CXType leaf = element;
    while (clang_getCanonicalType(leaf).kind == CXType_ConstantArray) {
      dimensions += fmt::format("[{}]", clang_getArraySize(clang_getCanonicalType(leaf)));
      leaf = clang_getArrayElementType(clang_getCanonicalType(leaf));
      is_const = is_const || clang_isConstQualifiedType(leaf);
    }
    records(leaf);
    std::string plain = spelling(clang_getUnqualifiedType(leaf));
    std::string flat = fmt::format(
        "for (auto* p = reinterpret_cast<{0}*>({1}); p != reinterpret_cast<{0}*>({1}) + sizeof {1} / "
        "sizeof({0}); ++p)",
        plain, name);
    declarations_ += fmt::format("  static {} {}{};\n", plain, name, dimensions);
    filling_ += fmt::format("    {} testbench::fill(*p);\n", flat);
    arguments_ += name;
    if (!is_const) printing_ += fmt::format("    {} testbench::show(*p);\n", flat);
  }

  void stream(const std::string& name, CXType type, int count) {
    CXType token = clang_Type_getTemplateArgumentAsType(clang_getCanonicalType(type), 0);
    records(token);
    bool is_output = name.rfind("out", 0) == 0 || name.rfind("sink", 0) == 0;
    std::string token_name = spelling(token);
    declarations_ += fmt::format("  static hls::stream<{} > {}{};\n", token_name, name,
                                 count ? fmt::format("[{}]", count) : "");
    std::string each = count ? fmt::format("for (auto& one : {}) ", name)
                             : fmt::format("for (auto* all = &{}; all; all = nullptr) ", name);
    std::string one = count ? "one" : "(*all)";
    if (is_output)
      printing_ += fmt::format("    {}while (!{}.empty()) testbench::show({}.read());\n", each, one, one);
    else
      filling_ += fmt::format(
          "    {}for (int i = 0; i < {}; ++i) {{ {} token; testbench::fill(token); {}.write(token); }}\n",
          each, steering_.tokens, token_name, one);
    arguments_ += name;
  }

  Steering steering_;
  std::string text_;
  CXCursor top_{};
  std::set<std::string> known_records_;
  std::string record_functions_, declarations_, filling_, arguments_, printing_;
};

}  // namespace

Steering read_steering(const std::filesystem::path& kernel) {
  Steering steering;
  std::istringstream lines(read_file(kernel));
  std::smatch match;
  for (std::string line; std::getline(lines, line) && line.rfind("//", 0) == 0;) {
    if (std::regex_match(line, match, std::regex("// top: (\\w+)"))) steering.top = match[1];
    if (std::regex_match(line, match, std::regex("// calls: (\\d+)"))) steering.calls = std::stoi(match[1]);
    if (std::regex_match(line, match, std::regex("// tokens: (\\d+)"))) steering.tokens = std::stoi(match[1]);
    if (std::regex_match(line, match, std::regex("// range: (\\w+)=(-?\\d+)\\.\\.(-?\\d+)")))
      steering.ranges.push_back({match[1], {std::stoll(match[2]), std::stoll(match[3])}});
  }
  if (steering.top.empty())
    throw std::runtime_error(
        fmt::format("{} does not name its top; write `// top: NAME` in its head.", kernel.string()));
  return steering;
}

std::string generate_testbench(const std::filesystem::path& kernel,
                               const std::vector<std::filesystem::path>& include_folders,
                               std::uint64_t seed) {
  std::vector<std::string> flags = {"-std=c++17", "-Wno-everything"};
  for (const auto& folder : include_folders) flags.push_back("-I" + folder.string());
  std::vector<const char*> arguments;
  for (const std::string& flag : flags) arguments.push_back(flag.c_str());

  std::unique_ptr<void, decltype(&clang_disposeIndex)> index(clang_createIndex(0, 1), clang_disposeIndex);
  CXTranslationUnit raw =
      clang_parseTranslationUnit(index.get(), kernel.c_str(), arguments.data(),
                                 static_cast<int>(arguments.size()), nullptr, 0, CXTranslationUnit_None);
  if (!raw) throw std::runtime_error(fmt::format("{} cannot be parsed.", kernel.string()));
  std::unique_ptr<CXTranslationUnitImpl, decltype(&clang_disposeTranslationUnit)> unit(
      raw, clang_disposeTranslationUnit);
  return Testbench(kernel, read_steering(kernel)).generate(unit.get(), seed);
}

}  // namespace hlsc::differential
