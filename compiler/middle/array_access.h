/// Keeps the subscripts of partitioned arrays apart through LLVM's optimisations, which would melt them into
/// one byte offset.
#ifndef HLSC_MIDDLE_ARRAY_ACCESS_H
#define HLSC_MIDDLE_ARRAY_ACCESS_H

#include <cstdint>
#include <string>
#include <vector>

#include "frontend/frontend.h"
#include "middle/directives_to_ir.h"

namespace llvm {
class CallInst;
class DataLayout;
class Module;
class Type;
class Value;
}  // namespace llvm

namespace hlsc {

/// A scalar member of an object's type with the array dimensions around it: `struct { T tap[4]; } filter[8]`
/// has the leaf `tap` with dims 8, 4. Every leaf becomes a memory of its own.
struct MemoryLeaf {
  std::string path;               ///< Member names by index, empty for arrays of scalars.
  uint64_t byte_offset = 0;       ///< With all subscripts 0.
  unsigned bytes = 0;             ///< Of one element.
  std::vector<uint64_t> dims;     ///< Outermost first.
  std::vector<uint64_t> strides;  ///< Bytes per step of each dimension.
};

/// The leaves of an object type, in order of their offsets.
std::vector<MemoryLeaf> memory_leaves(const llvm::DataLayout& layout, llvm::Type* type);

/// Rewrites the addresses of partitioned and of irregular objects (arrays inside structs, local or a
/// parameter) as `ptr hls.element(object, leaf offset, subscripts...)`. Throws CompileError where a pointer
/// into such an object is not a plain subscript. A partition of an array between processes has no effect: a
/// warning.
void separate_subscripts(const Program& program, const DirectiveTable& directives, Diagnostics& diagnostics);

/// Turns `hls.element` back into plain addresses where all subscripts of the object became constants, so that
/// it dissolves into registers.
void dissolve_constant_subscripts(llvm::Value& object);

/// The same for all local objects.
void dissolve_constant_subscripts(llvm::Module& module);

/// True for calls made by separate_subscripts.
bool is_element_address(const llvm::Value* value);

}  // namespace hlsc

#endif
