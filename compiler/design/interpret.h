/// Executes a process as its plain structs mean it: the reference that each stage of the compiler is checked
/// against, without Verilog.
#ifndef HLSC_DESIGN_INTERPRET_H
#define HLSC_DESIGN_INTERPRET_H

#include <llvm/ADT/APInt.h>

#include <deque>
#include <vector>

#include "design/design.h"
#include "schedule/schedule_process.h"

namespace hlsc {

/// What lies around a process in a run, by the indices of its own lists; words have the widths of the ports.
struct Surroundings {
  std::vector<std::deque<llvm::APInt>> inputs;     ///< Tokens that wait, by stream.
  std::vector<std::vector<llvm::APInt>> outputs;   ///< Tokens written, by stream.
  std::vector<std::vector<llvm::APInt>> memories;  ///< Contents of memory ports, by memory.
  std::vector<llvm::APInt> scalars;                ///< By scalar port; outputs are set.
};

/// Runs a process operation by operation. With a schedule, blocks run clock by clock with the iterations of a
/// pipelined loop overlapping as they do in hardware: a value is read when the schedule says that it is
/// there.
class Interpreter {
 public:
  /// Both must outlive the interpreter. `schedule` may be null: then every iteration ends before the next.
  Interpreter(const Process& process, const ProcessSchedule* schedule);

  /// From start to done; statics keep their contents from run to run, and so do the values that a loop of
  /// calls hands to the next. Throws std::runtime_error when the
  /// process reads a stream without a token, does not end, or acts before it may.
  void run(Surroundings& around);

 private:
  /// Values of one iteration of a pipelined loop; those of its operations are known once they have started.
  struct Iteration {
    int index = 0;
    std::vector<llvm::APInt> values;
    std::vector<bool> known;
  };
  struct PendingStore {
    ValueId id;
    size_t address;
    llvm::APInt word;
  };

  void reset_memories();
  /// Runs the block and tells the one that follows; -1 behind a return.
  int run_block(int block, int from, Surroundings& around);
  void run_pipeline(int block, int from, Surroundings& around);
  /// The operations of all iterations that start in this clock.
  void step(int block, int from, int clock, int last, std::deque<Iteration>& running, Surroundings& around);
  int successor(int block) const;
  /// The block's operations by cycle, those of one cycle in program order.
  std::vector<ValueId> in_order(const Block& block) const;

  llvm::APInt value(ValueId id) const;
  bool holds(ValueId predicate) const;
  /// An operand as its consumers see it: cut, or extended as its representation says.
  llvm::APInt operand(const Operation& op, size_t index, unsigned width) const;
  void evaluate(ValueId id, Surroundings& around);
  llvm::APInt result(const Operation& op, Surroundings& around);
  llvm::APInt arithmetic(const Operation& op) const;
  bool compared(const Operation& op) const;
  llvm::APInt entering(ValueId phi, int from) const;
  llvm::APInt loaded(const Operation& op, Surroundings& around);
  void store(ValueId id, Surroundings& around);
  void apply_stores(Surroundings& around);
  std::vector<llvm::APInt>& words(int memory, Surroundings& around);
  /// The value as the operation's representation keeps it.
  static llvm::APInt represented(const Operation& op, const llvm::APInt& value);

  const Process& process_;
  const ProcessSchedule* schedule_;
  std::vector<llvm::APInt> values_;
  std::vector<std::vector<llvm::APInt>> memories_;
  std::vector<PendingStore> stores_;
  const Surroundings* around_ = nullptr;
  Iteration* iteration_ = nullptr;  ///< The one whose operations are computed, in a pipeline.
  int pipeline_ = -1, clock_ = 0;   ///< Its block; cycles since it began.
  long steps_ = 0;
  bool has_run_ = false;
};

}  // namespace hlsc

#endif
