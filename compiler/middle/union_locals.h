/// Unions whose members are taken at places known at run time: `union { uint32_t word; uint8_t bytes[4]; }`.
#ifndef HLSC_MIDDLE_UNION_LOCALS_H
#define HLSC_MIDDLE_UNION_LOCALS_H

namespace llvm {
class Function;
}

namespace hlsc {

/// Makes each small local union with variable subscripts one integer, of which accesses shift out or in their
/// part.
void unions_to_integers(llvm::Function& function);

}  // namespace hlsc

#endif
