/// Constructors of static objects run at compile time: what they leave is the object's reset value.
#ifndef HLSC_MIDDLE_STATIC_OBJECTS_H
#define HLSC_MIDDLE_STATIC_OBJECTS_H

namespace llvm {
class Module;
}

namespace hlsc {

/// Evaluates the constructors of globals and of static locals. A static local whose constructor needs values
/// of the run keeps its guard and is constructed in the first run. Throws CompileError for a global whose
/// constructor cannot be evaluated. Runs after inlining and the promotion of locals.
void construct_static_objects(llvm::Module& module);

}  // namespace hlsc

#endif
