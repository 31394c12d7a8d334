/// Resolves the pragma markers in LLVM IR: to loop metadata, function attributes, and a table of object
/// directives.
#ifndef HLSC_MIDDLE_DIRECTIVES_TO_IR_H
#define HLSC_MIDDLE_DIRECTIVES_TO_IR_H

#include <llvm/IR/ValueHandle.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "frontend/diagnostic.h"
#include "frontend/directive.h"

namespace llvm {
class BasicBlock;
class Function;
class LLVMContext;
class Loop;
class MDNode;
class Module;
}  // namespace llvm

namespace hlsc {

/// A directive on an array or stream (alloca, global or pointer argument), or on a member of one: on `bytes`
/// from `offset`, an array with `dims` subscripts.
struct ObjectDirective {
  llvm::WeakTrackingVH object;
  uint64_t offset = 0, bytes = 0;
  size_t dims = 0;
  Directive directive;
  SourceLocation location;

  bool covers(uint64_t byte) const { return byte >= offset && byte < offset + bytes; }
};

/// A directive on a port of a function.
struct PortDirective {
  std::string port;  ///< Parameter name, "return", or empty.
  Directive directive;
  SourceLocation location;
};

struct DirectiveTable {
  std::vector<ObjectDirective> objects;
  std::map<std::string, std::vector<PortDirective>> ports;  ///< By mangled function name.

  /// Directives of one kind on an object, in source order.
  std::vector<ObjectDirective> of(const llvm::Value* object, const std::string& kind) const;
};

/// Removes all markers without a variable (to loop metadata and function attributes) and those of INTERFACE.
/// Unknown pragmas become warnings. Runs on unoptimised IR, before inlining.
void resolve_loop_directives(llvm::Module& module, DirectiveTable& table, Diagnostics& diagnostics);

/// Loops that a call brought into a pipelined loop or function dissolve as those that stand there do, and so
/// do loops that calculate real numbers of their counters, so that LLVM can. Runs after inlining.
void unroll_inlined_loops(llvm::Module& module);

/// Removes the markers with a variable. Runs after inlining, when each names the object itself.
void resolve_object_directives(llvm::Module& module, DirectiveTable& table, Diagnostics& diagnostics);

/// Option of a DEPENDENCE that stands in a loop: a number, which that loop and the loops in it have among
/// their directives. One outside of loops holds in all.
constexpr const char* kClaim = "claim";

/// The directives of `kind` on a loop.
std::vector<Directive> loop_directives(const llvm::Loop& loop, const std::string& kind);

/// The last directive of `kind` on a loop, if there is one.
std::optional<Directive> loop_directive(const llvm::Loop& loop, const std::string& kind);

/// A loop's metadata with `directive` in place of the one of its kind.
llvm::MDNode* with_directive(llvm::MDNode* id, const Directive& directive, llvm::LLVMContext& context);

/// The directive of `kind` in whose body the function's own code stands (not in a loop).
std::optional<Directive> function_directive(const llvm::Function& function, const std::string& kind);

}  // namespace hlsc

#endif
