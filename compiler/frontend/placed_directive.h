/// A directive that stands outside the source and names its place.
#ifndef HLSC_FRONTEND_PLACED_DIRECTIVE_H
#define HLSC_FRONTEND_PLACED_DIRECTIVE_H

#include <string>

#include "frontend/diagnostic.h"

namespace hlsc {

struct PlacedDirective {
  std::string function;  ///< Name or qualified name.
  std::string label;     ///< Of a loop, or VITIS_LOOP_line_number; empty: the function itself.
  std::string variable;  ///< Empty without one.
  std::string text;      ///< `KIND key=value flag`.
  SourceLocation location;
};

}  // namespace hlsc

#endif
