/// Tables that the program fills with constants before it reads them: `void fill(int t[256])` with a loop.
#ifndef HLSC_MIDDLE_CONSTANT_TABLES_H
#define HLSC_MIDDLE_CONSTANT_TABLES_H

namespace llvm {
class Function;
}

namespace hlsc {

/// Makes a local or static array a constant one when all that is stored there are constants at constant
/// places, in one block that ends before the first load. Runs when the loops that fill tables are unrolled
/// and folded.
void make_tables_constant(llvm::Function& function);

}  // namespace hlsc

#endif
