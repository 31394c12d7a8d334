/// Puts directives that stand outside the source into it, as if they were written there.
#ifndef HLSC_FRONTEND_DIRECTIVE_INSERTION_H
#define HLSC_FRONTEND_DIRECTIVE_INSERTION_H

#include <map>
#include <set>
#include <string>
#include <vector>

#include "frontend/placed_directive.h"

namespace clang {
class ASTContext;
}

namespace hlsc {

/// Text to insert, by file and offset. `_Pragma` keeps all lines where they are.
using Insertions = std::map<std::string, std::multimap<unsigned, std::string>>;

/// Finds the places of `directives` in one translation unit; adds the numbers of those found to `found`.
Insertions find_insertions(clang::ASTContext& context, const std::vector<PlacedDirective>& directives,
                           std::set<size_t>& found);

/// `source` with the texts inserted.
std::string inserted(const std::string& source, const std::multimap<unsigned, std::string>& texts);

}  // namespace hlsc

#endif
