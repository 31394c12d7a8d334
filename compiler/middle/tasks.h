/// hls::task: calls of a DATAFLOW function whose processes run for themselves.
#ifndef HLSC_MIDDLE_TASKS_H
#define HLSC_MIDDLE_TASKS_H

namespace llvm {
class CallInst;
class Module;
}  // namespace llvm

namespace hlsc {

/// Puts the call that an hls::task makes in its place, and marks it. Runs on unoptimised IR, before the
/// pragmas: the task brings a DATAFLOW.
void place_tasks(llvm::Module& module);

/// The call came from an hls::task.
bool is_task(const llvm::CallInst& call);

}  // namespace hlsc

#endif
