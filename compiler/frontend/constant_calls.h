/// Calls of constexpr functions with constant arguments become literals before code is generated.
#ifndef HLSC_FRONTEND_CONSTANT_CALLS_H
#define HLSC_FRONTEND_CONSTANT_CALLS_H

#include <clang/AST/DeclGroup.h>

namespace clang {
class ASTContext;
}

namespace hlsc {

/// Clang generates a call outside of constant expressions; the function may be recursive, which hardware
/// cannot be.
void fold_constant_calls(clang::ASTContext& context, clang::DeclGroupRef declarations);

}  // namespace hlsc

#endif
