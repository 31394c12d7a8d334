#include "frontend/language_checks.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/Basic/SourceManager.h>

#include <set>
#include <string>

#include "frontend/pragma_handler.h"

namespace hlsc {
namespace {

class LanguageChecker : public clang::RecursiveASTVisitor<LanguageChecker> {
 public:
  explicit LanguageChecker(clang::ASTContext& context) : context_(context) {}

  bool VisitCXXNewExpr(clang::CXXNewExpr* expression) {
    refuse(expression->getBeginLoc(), "'new' needs a heap, which hardware lacks; use an array of fixed size");
    return true;
  }
  bool VisitCXXDeleteExpr(clang::CXXDeleteExpr* expression) {
    refuse(expression->getBeginLoc(),
           "'delete' needs a heap, which hardware lacks; use an array of fixed size");
    return true;
  }
  bool VisitCXXMethodDecl(clang::CXXMethodDecl* method) {
    if (method->isVirtual())
      refuse(method->getLocation(),
             "virtual functions have no hardware form; use a template parameter or a plain member function");
    return true;
  }
  bool VisitCallExpr(clang::CallExpr* call) {
    const clang::FunctionDecl* callee = call->getDirectCallee();
    if (!callee || !callee->getIdentifier()) return true;
    llvm::StringRef name = callee->getName();
    if (name == "malloc" || name == "calloc" || name == "realloc" || name == "free")
      refuse(call->getBeginLoc(),
             "'" + name.str() + "' needs a heap, which hardware lacks; use an array of fixed size");
    return true;
  }
  bool VisitParmVarDecl(clang::ParmVarDecl* parameter) {
    const clang::CXXRecordDecl* record = parameter->getType()->getAsCXXRecordDecl();
    if (record && record->getQualifiedNameAsString() == "hls::stream")
      refuse(parameter->getLocation(),
             "stream '" + parameter->getNameAsString() +
                 "' is passed by value, but cannot be copied; pass it by reference");
    return true;
  }
  bool VisitVarDecl(clang::VarDecl* variable) {
    static const std::set<std::string> kHeapTypes = {
        "std::vector",        "std::deque",         "std::list",
        "std::map",           "std::set",           "std::queue",
        "std::stack",         "std::unordered_map", "std::unique_ptr",
        "std::shared_ptr",    "std::function",      "std::multimap",
        "std::unordered_set", "std::basic_string",  "std::__cxx11::basic_string"};
    const clang::CXXRecordDecl* record = variable->getType()->getAsCXXRecordDecl();
    std::string name = record ? record->getQualifiedNameAsString() : "";
    if (variable->isLocalVarDeclOrParm() && kHeapTypes.count(name) && !is_in_main(variable))
      refuse(variable->getLocation(), "'" + variable->getType().getAsString() +
                                          "' needs a heap, which hardware lacks; use an array of fixed size");
    return true;
  }
  bool VisitDoStmt(clang::DoStmt* loop) { return check_body(loop->getBody()); }
  bool VisitIfStmt(clang::IfStmt* branch) {
    return check_body(branch->getThen()) && check_body(branch->getElse());
  }

 private:
  /// A pragma before a lone statement of `if` or `do` would take the statement's place.
  bool check_body(const clang::Stmt* body) {
    const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(body);
    const clang::FunctionDecl* callee = call ? call->getDirectCallee() : nullptr;
    if (callee && callee->getIdentifier() && callee->getName() == kPragmaMarker)
      refuse(call->getBeginLoc(),
             "the pragma stands between a statement and its body; put braces around the body and the pragma "
             "inside");
    return true;
  }

  static bool is_in_main(const clang::VarDecl* variable) {
    const auto* function = llvm::dyn_cast<clang::FunctionDecl>(variable->getDeclContext());
    return function && function->isMain();
  }

  void refuse(clang::SourceLocation where, const std::string& sentence) {
    if (context_.getSourceManager().isInSystemHeader(where)) return;
    clang::DiagnosticsEngine& diagnostics = context_.getDiagnostics();
    diagnostics.Report(where, diagnostics.getCustomDiagID(clang::DiagnosticsEngine::Error, "%0")) << sentence;
  }

  clang::ASTContext& context_;
};

}  // namespace

void check_language(clang::ASTContext& context) {
  LanguageChecker(context).TraverseDecl(context.getTranslationUnitDecl());
}

}  // namespace hlsc
