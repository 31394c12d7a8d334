/// Layout of C++ types as hardware sees them: the scalar leaves of a type with their true bit widths.
#ifndef HLSC_FRONTEND_TYPE_LAYOUT_H
#define HLSC_FRONTEND_TYPE_LAYOUT_H

#include <cstdint>
#include <string>
#include <vector>

namespace clang {
class ASTContext;
class QualType;
}  // namespace clang

namespace hlsc {

/// One scalar inside a type: `name` is its path (`pixel.r`, `taps[3]`, empty for a scalar type itself).
struct Leaf {
  std::string name;
  uint64_t byte_offset = 0;
  unsigned bytes = 0;  ///< Size in memory.
  unsigned width = 0;  ///< Bits that carry the value.
  bool is_signed = false;
};

/// All leaves in order of declaration. Bit 0 of the packed form is bit 0 of the first leaf.
struct TypeLayout {
  std::string type_name;
  std::vector<Leaf> leaves;
  uint64_t bytes = 0;

  unsigned width() const {
    unsigned total = 0;
    for (const Leaf& leaf : leaves) total += leaf.width;
    return total;
  }
};

/// Layout of `type`; throws CompileError for pointers, floats, unions, bit-fields and other types without
/// one.
TypeLayout layout_of(clang::ASTContext& context, clang::QualType type);

}  // namespace hlsc

#endif
