/// Local tables of pointers: `int* rows[2] = {x, y}`, chosen from at run time.
#ifndef HLSC_MIDDLE_POINTER_TABLES_H
#define HLSC_MIDDLE_POINTER_TABLES_H

namespace llvm {
class Function;
}

namespace hlsc {

/// Makes a pointer that is loaded from a table a choice of those that were stored there, each once before all
/// loads.
void resolve_pointer_tables(llvm::Function& function);

}  // namespace hlsc

#endif
