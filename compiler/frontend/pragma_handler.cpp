#include "frontend/pragma_handler.h"

#include <clang/Basic/IdentifierTable.h>
#include <clang/Lex/Pragma.h>
#include <clang/Lex/Preprocessor.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace hlsc {

const char* const kPragmaMarker = "__hls_pragma";
const char* const kPragmaPrelude =
    "#ifdef __cplusplus\n"
    "extern \"C\"\n"
    "#endif\n"
    "__attribute__((nothrow)) void __hls_pragma(const char*, const char*, const void*, ...);\n";

namespace {

/// Options whose value is a number, so that a name there is an expression of the program.
bool is_numeric_option(llvm::StringRef key) {
  static const std::set<std::string> names = {"ii",  "factor", "dim",     "depth",    "min",
                                              "max", "avg",    "latency", "distance", "limit"};
  return names.count(key.lower()) != 0;
}

using Tokens = llvm::SmallVector<clang::Token, 16>;

/// Where the next token stands: whether it begins the body of a for or while loop, or a member of a class.
class LoopHeads {
 public:
  void see(const clang::Token& token) {
    see_brace(token);
    at_body_ = false;
    if (token.is(clang::tok::l_paren)) {
      open_.push_back(is_head_);
    } else if (token.is(clang::tok::r_paren) && !open_.empty()) {
      at_body_ = open_.back();
      open_.pop_back();
    }
    is_head_ = token.isOneOf(clang::tok::kw_for, clang::tok::kw_while) ||
               (token.is(clang::tok::kw_if) && passes_on_body_);
    if (token.is(clang::tok::kw_if)) passes_on_body_ = false;
  }
  bool at_body() const { return at_body_; }
  /// Between the members of a class.
  bool in_class() const { return !braces_.empty() && braces_.back(); }
  /// The next `if` is a pragma's: what follows its condition is still the loop's body.
  void pass_on_body() { passes_on_body_ = true; }

 private:
  /// A brace behind `class`, `struct` or `union` and no parameters is a class's.
  void see_brace(const clang::Token& token) {
    if (token.isOneOf(clang::tok::kw_class, clang::tok::kw_struct, clang::tok::kw_union)) names_class_ = true;
    if (token.isOneOf(clang::tok::kw_enum, clang::tok::l_paren)) is_other_ = true;
    if (token.is(clang::tok::l_brace)) braces_.push_back(names_class_ && !is_other_);
    if (token.is(clang::tok::r_brace) && !braces_.empty()) braces_.pop_back();
    if (token.isOneOf(clang::tok::l_brace, clang::tok::r_brace, clang::tok::semi))
      names_class_ = is_other_ = false;
  }

  std::vector<bool> braces_;  ///< Open ones; true: of a class.
  bool names_class_ = false, is_other_ = false;
  std::vector<bool> open_;  ///< Parentheses; true: of a loop's head.
  bool is_head_ = false, at_body_ = false, passes_on_body_ = false;
};

class HlsPragmaHandler : public clang::PragmaHandler {
 public:
  HlsPragmaHandler(std::shared_ptr<LoopHeads> heads, llvm::StringRef spelling)
      : PragmaHandler(spelling), heads_(std::move(heads)) {}

  void HandlePragma(clang::Preprocessor& preprocessor, clang::PragmaIntroducer,
                    clang::Token& first) override {
    Tokens line;
    clang::Token token;
    for (preprocessor.Lex(token); token.isNot(clang::tok::eod); preprocessor.Lex(token))
      line.push_back(token);
    if (heads_->in_class()) {
      clang::DiagnosticsEngine& diagnostics = preprocessor.getDiagnostics();
      diagnostics.Report(first.getLocation(),
                         diagnostics.getCustomDiagID(clang::DiagnosticsEngine::Error,
                                                     "a pragma has no effect between the members of a class; "
                                                     "move it into the constructor or a member function"));
      return;
    }
    Tokens call = marker_call(preprocessor, line, first.getLocation());
    inject(preprocessor, heads_->at_body() ? before_body(preprocessor, call, first.getLocation())
                                           : as_statement(call, first.getLocation()));
  }

 private:
  /// Index just after the option value that starts at `at`: operands joined by operators (`max = WIDTH *
  /// HEIGHT + 1`).
  static size_t end_of_value(const Tokens& line, size_t at) {
    int open = 0;
    size_t end = at;
    bool operand_done = false;
    for (; end < line.size(); ++end) {
      const clang::Token& token = line[end];
      bool opens = token.isOneOf(clang::tok::l_paren, clang::tok::l_square);
      bool closes = token.isOneOf(clang::tok::r_paren, clang::tok::r_square);
      bool is_operand = token.getIdentifierInfo() || token.isLiteral();  // Keywords, too: `port=in register`.
      if (open == 0 && operand_done && (is_operand || token.is(clang::tok::comma))) break;
      open += opens - closes;
      operand_done = is_operand || closes;
    }
    return end;
  }

  Tokens marker_call(clang::Preprocessor& preprocessor, const Tokens& line, clang::SourceLocation where) {
    std::string text, variable_name;
    Tokens variable, numbers;
    int number_count = 0;
    for (size_t i = 0; i < line.size();) {
      std::string word = preprocessor.getSpelling(line[i]);
      bool is_option = i + 2 < line.size() && line[i + 1].is(clang::tok::equal);
      if (!is_option) {
        text += (text.empty() ? "" : " ") + word;
        ++i;
        continue;
      }
      size_t value_end = end_of_value(line, i + 2);
      size_t value_begin = i + 2 + line[i + 2].is(clang::tok::amp);  // `variable=&buffer`: older code.
      std::string value;
      for (size_t k = value_begin; k < value_end; ++k) value += preprocessor.getSpelling(line[k]);
      bool names_variable =
          (llvm::StringRef(word).lower() == "variable" || llvm::StringRef(word).lower() == "port") &&
          value != "return";
      if (names_variable) {
        variable_name = value;
        variable.assign(line.begin() + value_begin, line.begin() + value_end);
      } else if (is_numeric_option(word) && line[i + 2].isNot(clang::tok::numeric_constant) &&
                 line[i + 2].isNot(clang::tok::minus)) {
        punctuate(numbers, clang::tok::comma, where);
        punctuate(numbers, clang::tok::l_paren, where);
        append_word(preprocessor, numbers, "long", where);
        punctuate(numbers, clang::tok::r_paren, where);
        punctuate(numbers, clang::tok::l_paren, where);
        numbers.append(line.begin() + i + 2, line.begin() + value_end);
        punctuate(numbers, clang::tok::r_paren, where);
        text += " " + word + "=$" + std::to_string(number_count++);
      } else {
        text += " " + word + "=" + value;
      }
      i = value_end;
    }

    Tokens call;
    append_word(preprocessor, call, kPragmaMarker, where);
    punctuate(call, clang::tok::l_paren, where);
    append_string(preprocessor, call, text, where);
    punctuate(call, clang::tok::comma, where);
    append_string(preprocessor, call, variable_name, where);
    punctuate(call, clang::tok::comma, where);
    append_variable(preprocessor, call, variable, where);
    call.append(numbers.begin(), numbers.end());
    punctuate(call, clang::tok::r_paren, where);
    return call;
  }

  static Tokens as_statement(Tokens call, clang::SourceLocation where) {
    punctuate(call, clang::tok::semi, where);
    return call;
  }

  /// `if ((call, 1))`, of which the loop's lone statement becomes the body: a pragma may stand before it.
  Tokens before_body(clang::Preprocessor& preprocessor, const Tokens& call, clang::SourceLocation where) {
    heads_->pass_on_body();
    Tokens head;
    append_word(preprocessor, head, "if", where);
    punctuate(head, clang::tok::l_paren, where);
    punctuate(head, clang::tok::l_paren, where);
    head.append(call.begin(), call.end());
    punctuate(head, clang::tok::comma, where);
    head.push_back(blank(clang::tok::numeric_constant, where));
    preprocessor.CreateString("1", head.back(), where, where);
    punctuate(head, clang::tok::r_paren, where);
    punctuate(head, clang::tok::r_paren, where);
    return head;
  }

  static clang::Token blank(clang::tok::TokenKind kind, clang::SourceLocation where) {
    clang::Token token;
    token.startToken();
    token.setKind(kind);
    token.setLocation(where);
    return token;
  }
  static void punctuate(Tokens& out, clang::tok::TokenKind kind, clang::SourceLocation where) {
    out.push_back(blank(kind, where));
    out.back().setLength(1);
  }
  static void append_word(clang::Preprocessor& preprocessor, Tokens& out, llvm::StringRef word,
                          clang::SourceLocation where) {
    clang::IdentifierInfo* info = preprocessor.getIdentifierInfo(word);
    out.push_back(blank(info->getTokenID(), where));
    out.back().setIdentifierInfo(info);
    out.back().setLength(word.size());
  }
  static void append_string(clang::Preprocessor& preprocessor, Tokens& out, const std::string& text,
                            clang::SourceLocation where) {
    clang::Token token = blank(clang::tok::string_literal, where);
    preprocessor.CreateString("\"" + text + "\"", token, where, where);
    out.push_back(token);
  }
  /// `(const void*)&(variable)`, or `0` without a variable.
  static void append_variable(clang::Preprocessor& preprocessor, Tokens& out, const Tokens& variable,
                              clang::SourceLocation where) {
    if (variable.empty()) {
      out.push_back(blank(clang::tok::numeric_constant, where));
      preprocessor.CreateString("0", out.back(), where, where);
      return;
    }
    punctuate(out, clang::tok::l_paren, where);
    append_word(preprocessor, out, "const", where);
    append_word(preprocessor, out, "void", where);
    punctuate(out, clang::tok::star, where);
    punctuate(out, clang::tok::r_paren, where);
    punctuate(out, clang::tok::amp, where);
    punctuate(out, clang::tok::l_paren, where);
    out.append(variable.begin(), variable.end());
    punctuate(out, clang::tok::r_paren, where);
  }

  static void inject(clang::Preprocessor& preprocessor, const Tokens& tokens) {
    auto owned = std::make_unique<clang::Token[]>(tokens.size());
    std::copy(tokens.begin(), tokens.end(), owned.get());
    preprocessor.EnterTokenStream(std::move(owned), tokens.size(), /*DisableMacroExpansion=*/true,
                                  /*IsReinject=*/false);
  }

  std::shared_ptr<LoopHeads> heads_;
};

}  // namespace

void add_pragma_handler(clang::Preprocessor& preprocessor) {
  auto heads = std::make_shared<LoopHeads>();
  preprocessor.setTokenWatcher([heads](const clang::Token& token) { heads->see(token); });
  for (const char* spelling : {"HLS", "hls", "AP"})
    preprocessor.AddPragmaHandler(new HlsPragmaHandler(heads, spelling));
}

}  // namespace hlsc
