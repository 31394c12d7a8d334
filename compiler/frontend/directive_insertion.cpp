#include "frontend/directive_insertion.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Lex/Lexer.h>

namespace hlsc {
namespace {

class PlaceFinder : public clang::RecursiveASTVisitor<PlaceFinder> {
 public:
  PlaceFinder(clang::ASTContext& context, const std::vector<PlacedDirective>& directives,
              std::set<size_t>& found)
      : sources_(context.getSourceManager()),
        language_(context.getLangOpts()),
        directives_(directives),
        found_(found) {}

  Insertions run(clang::ASTContext& context) {
    TraverseDecl(context.getTranslationUnitDecl());
    return insertions_;
  }

  bool VisitFunctionDecl(clang::FunctionDecl* function) {
    if (!function->isThisDeclarationADefinition() || !function->getBody() ||
        sources_.isInSystemHeader(function->getLocation()))
      return true;
    for (size_t i = 0; i < directives_.size(); ++i) {
      bool is_meant = function->getNameAsString() == directives_[i].function ||
                      function->getQualifiedNameAsString() == directives_[i].function;
      if (is_meant) place(*function, i);
    }
    return true;
  }

 private:
  void place(clang::FunctionDecl& function, size_t number) {
    const PlacedDirective& directive = directives_[number];
    if (!directive.label.empty()) {
      if (clang::Stmt* body = loop_body(function.getBody(), directive.label)) insert_into(body, number);
      return;
    }
    bool is_parameter = directive.variable.empty() || directive.variable == "return";
    for (const clang::ParmVarDecl* parameter : function.parameters())
      is_parameter |= parameter->getName() == directive.variable;
    if (is_parameter)
      insert_into(function.getBody(), number);
    else
      insert_behind_declaration(function.getBody(), number);
  }

  static clang::Stmt* body_of(clang::Stmt* statement) {
    if (auto* loop = llvm::dyn_cast_or_null<clang::ForStmt>(statement)) return loop->getBody();
    if (auto* loop = llvm::dyn_cast_or_null<clang::WhileStmt>(statement)) return loop->getBody();
    if (auto* loop = llvm::dyn_cast_or_null<clang::DoStmt>(statement)) return loop->getBody();
    if (auto* loop = llvm::dyn_cast_or_null<clang::CXXForRangeStmt>(statement)) return loop->getBody();
    return nullptr;
  }

  /// The body of the loop with this label; Vitis names unlabelled loops VITIS_LOOP_line_number.
  clang::Stmt* loop_body(clang::Stmt* statement, const std::string& label) {
    if (!statement) return nullptr;
    if (auto* labelled = llvm::dyn_cast<clang::LabelStmt>(statement);
        labelled && labelled->getName() == label)
      return body_of(labelled->getSubStmt());
    std::string by_line =
        "VITIS_LOOP_" + std::to_string(sources_.getPresumedLineNumber(statement->getBeginLoc())) + "_";
    if (body_of(statement) && label.rfind(by_line, 0) == 0) return body_of(statement);
    for (clang::Stmt* child : statement->children())
      if (clang::Stmt* body = loop_body(child, label)) return body;
    return nullptr;
  }

  void insert_behind_declaration(clang::Stmt* statement, size_t number) {
    if (!statement) return;
    if (auto* declaration = llvm::dyn_cast<clang::DeclStmt>(statement))
      for (const clang::Decl* one : declaration->decls())
        if (auto* variable = llvm::dyn_cast<clang::VarDecl>(one);
            variable && variable->getName() == directives_[number].variable)
          insert(declaration->getEndLoc().getLocWithOffset(1), pragma(number), number);
    for (clang::Stmt* child : statement->children()) insert_behind_declaration(child, number);
  }

  void insert_into(clang::Stmt* body, size_t number) {
    if (auto* compound = llvm::dyn_cast<clang::CompoundStmt>(body)) {
      insert(compound->getLBracLoc().getLocWithOffset(1), pragma(number), number);
      return;
    }
    clang::SourceLocation end = clang::Lexer::getLocForEndOfToken(body->getEndLoc(), 0, sources_, language_);
    clang::SourceLocation behind =
        clang::Lexer::findLocationAfterToken(body->getEndLoc(), clang::tok::semi, sources_, language_, false);
    insert(body->getBeginLoc(), "{" + pragma(number), number);
    insert(behind.isValid() ? behind : end, " }", number);
  }

  void insert(clang::SourceLocation where, const std::string& text, size_t number) {
    clang::SourceLocation in_file = sources_.getFileLoc(where);
    insertions_[sources_.getFilename(in_file).str()].emplace(sources_.getFileOffset(in_file), text);
    found_.insert(number);
  }

  std::string pragma(size_t number) const {
    const PlacedDirective& directive = directives_[number];
    std::string text = "HLS " + directive.text;
    bool is_interface =
        directive.text.rfind("interface", 0) == 0 || directive.text.rfind("INTERFACE", 0) == 0;
    if (is_interface)
      text += " port=" + (directive.variable.empty() ? "return" : directive.variable);
    else if (!directive.variable.empty())
      text += " variable=" + directive.variable;
    return " _Pragma(\"" + text + "\") ";
  }

  clang::SourceManager& sources_;
  const clang::LangOptions& language_;
  const std::vector<PlacedDirective>& directives_;
  std::set<size_t>& found_;
  Insertions insertions_;
};

}  // namespace

Insertions find_insertions(clang::ASTContext& context, const std::vector<PlacedDirective>& directives,
                           std::set<size_t>& found) {
  return PlaceFinder(context, directives, found).run(context);
}

std::string inserted(const std::string& source, const std::multimap<unsigned, std::string>& texts) {
  std::string result;
  unsigned from = 0;
  for (const auto& [offset, text] : texts) {
    result += source.substr(from, offset - from) + text;
    from = offset;
  }
  return result + source.substr(from);
}

}  // namespace hlsc
