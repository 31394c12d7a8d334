/// A stream that one process both writes and reads is a queue: a ring in an array.
#ifndef HLSC_MIDDLE_STREAM_QUEUES_H
#define HLSC_MIDDLE_STREAM_QUEUES_H

#include "frontend/diagnostic.h"
#include "middle/directives_to_ir.h"

namespace hlsc {

/// Replaces the streams that no call of `module` takes, local or static, outside DATAFLOW functions. A queue
/// has as many places as STREAM depth says; without it there is a warning. Runs when all calls but those of
/// processes are inlined and the table has the directives.
void build_stream_queues(llvm::Module& module, const DirectiveTable& directives, Diagnostics& diagnostics);

}  // namespace hlsc

#endif
