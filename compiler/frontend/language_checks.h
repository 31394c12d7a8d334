/// Refuses what hardware cannot do while the syntax tree still knows the construct's name and place.
#ifndef HLSC_FRONTEND_LANGUAGE_CHECKS_H
#define HLSC_FRONTEND_LANGUAGE_CHECKS_H

namespace clang {
class ASTContext;
}

namespace hlsc {

/// Reports heap, virtual calls and misplaced pragmas in the user's sources through Clang's diagnostics.
void check_language(clang::ASTContext& context);

}  // namespace hlsc

#endif
