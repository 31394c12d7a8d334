/// Stream primitives on C++ objects become primitives on packed integers, so that the objects dissolve into
/// registers.
#ifndef HLSC_MIDDLE_STREAM_LOWERING_H
#define HLSC_MIDDLE_STREAM_LOWERING_H

#include <map>
#include <string>

#include "frontend/type_layout.h"

namespace llvm {
class CallInst;
class Module;
}  // namespace llvm

namespace hlsc {

/// What a call to a hardware primitive does. All take a predicate i1 as last argument.
enum class Primitive {
  kNone,
  kRead,   ///< iW hls.read.iW(ptr stream, i1)
  kWrite,  ///< void hls.write.iW(ptr stream, iW, i1)
  kEmpty,  ///< i1 hls.empty(ptr stream, i1)
  kFull,   ///< i1 hls.full(ptr stream, i1)
  kLoad,   ///< iW hls.load.iW(ptr, i1)
  kStore,  ///< void hls.store.iW(ptr, iW, i1)
};

Primitive primitive_of(const llvm::CallInst& call);

/// Replaces `__hls_stream_*<T>` calls; `types` gives T's layout by the callee's name.
void lower_streams(llvm::Module& module, const std::map<std::string, TypeLayout>& types);

}  // namespace hlsc

#endif
