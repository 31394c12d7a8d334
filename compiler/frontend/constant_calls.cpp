#include "frontend/constant_calls.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/RecursiveASTVisitor.h>

namespace hlsc {
namespace {

class Folder : public clang::RecursiveASTVisitor<Folder> {
 public:
  explicit Folder(clang::ASTContext& context) : context_(context) {}

  bool shouldVisitTemplateInstantiations() const { return true; }

  bool VisitStmt(clang::Stmt* statement) {
    for (clang::Stmt*& child : statement->children())
      if (clang::Expr* literal = literal_of(llvm::dyn_cast_or_null<clang::Expr>(child))) child = literal;
    return true;
  }
  bool VisitVarDecl(clang::VarDecl* variable) {
    bool is_default = llvm::isa<clang::ParmVarDecl>(variable);
    if (is_default && llvm::cast<clang::ParmVarDecl>(variable)->hasUninstantiatedDefaultArg()) return true;
    if (clang::Expr* literal = literal_of(variable->getInit())) variable->setInit(literal);
    return true;
  }

 private:
  /// The literal that a constant call equals; null for other expressions.
  clang::Expr* literal_of(clang::Expr* expression) {
    auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(expression);
    const clang::FunctionDecl* callee = call ? call->getDirectCallee() : nullptr;
    if (!callee || !callee->isConstexpr() || call->isValueDependent()) return nullptr;
    clang::QualType type = call->getType().getCanonicalType().getUnqualifiedType();
    clang::Expr::EvalResult result;
    if (!type->isIntegerType() || type->isEnumeralType() || type->isBooleanType() || call->isGLValue() ||
        !call->EvaluateAsInt(result, context_))
      return nullptr;
    return clang::IntegerLiteral::Create(context_, result.Val.getInt(), type, call->getBeginLoc());
  }

  clang::ASTContext& context_;
};

}  // namespace

void fold_constant_calls(clang::ASTContext& context, clang::DeclGroupRef declarations) {
  for (clang::Decl* declaration : declarations) Folder(context).TraverseDecl(declaration);
}

}  // namespace hlsc
