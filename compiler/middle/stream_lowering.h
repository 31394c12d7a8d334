/// Stream primitives on C++ objects become primitives on packed integers, so that the objects dissolve into
/// registers.
#ifndef HLSC_MIDDLE_STREAM_LOWERING_H
#define HLSC_MIDDLE_STREAM_LOWERING_H

#include <map>
#include <string>

#include "frontend/type_layout.h"

namespace llvm {
class Module;
}  // namespace llvm

namespace hlsc {

/// Replaces `__hls_stream_*<T>` calls; `types` gives T's layout by the callee's name.
void lower_streams(llvm::Module& module, const std::map<std::string, TypeLayout>& types);

}  // namespace hlsc

#endif
