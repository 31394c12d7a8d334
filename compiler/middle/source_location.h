/// Where an LLVM instruction comes from in the user's source.
#ifndef HLSC_MIDDLE_SOURCE_LOCATION_H
#define HLSC_MIDDLE_SOURCE_LOCATION_H

#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/Instruction.h>
#include <llvm/Support/Path.h>

#include "frontend/diagnostic.h"

namespace hlsc {

/// Types and streams of the vendor's library and the language's own headers are not the user's source.
inline bool is_library_file(llvm::StringRef file) {
  return file.contains("/hls_stream") || file.contains("/hls_task.h") || file.contains("/compat/") ||
         file.contains("/include/c++/");
}

inline SourceLocation location_of(const llvm::DebugLoc& debug) {
  if (!debug) return {};
  const llvm::DILocation* place = debug.get();
  while (is_library_file(place->getFilename()) && place->getInlinedAt()) place = place->getInlinedAt();
  return {place->getFilename().str(), place->getLine(), place->getColumn()};
}
/// With the whole path of the file, which debug information splits where the compile's folder begins alike.
inline SourceLocation whole_location_of(const llvm::DebugLoc& debug) {
  SourceLocation place = location_of(debug);
  if (!llvm::sys::path::is_absolute(place.file))
    place.file = (debug->getDirectory() + "/" + place.file).str();
  return place;
}
inline SourceLocation location_of(const llvm::Instruction& instruction) {
  return location_of(instruction.getDebugLoc());
}

/// The instruction's place, or the nearest known one in its block or function.
inline SourceLocation nearest_location(const llvm::Instruction& instruction) {
  if (instruction.getDebugLoc()) return location_of(instruction);
  for (const llvm::Instruction& other : *instruction.getParent())
    if (other.getDebugLoc()) return location_of(other);
  if (const llvm::DISubprogram* function = instruction.getFunction()->getSubprogram())
    return {function->getFilename().str(), function->getLine(), 0};
  return {};
}

}  // namespace hlsc

#endif
