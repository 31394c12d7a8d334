/// Removes pointers that are chosen at run time: `*(c ? a : b)`, pointers that walk through an array.
#ifndef HLSC_MIDDLE_POINTER_CHOICES_H
#define HLSC_MIDDLE_POINTER_CHOICES_H

namespace llvm {
class Function;
}

namespace hlsc {

/// An access through a select becomes one predicated access per arm; a load through a phi moves to the phi's
/// predecessors; a pointer phi within one object becomes a phi of its subscript. What remains is refused
/// later, at its access.
void resolve_pointer_choices(llvm::Function& function);

}  // namespace hlsc

#endif
