/// The emitter behind emit_process.h: one class, one source file per concept.
#ifndef HLSC_VERILOG_PROCESS_EMITTER_H
#define HLSC_VERILOG_PROCESS_EMITTER_H

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "design/design.h"
#include "design/names.h"
#include "schedule/schedule_process.h"

namespace hlsc {

/// Writes one module. The parts add to text streams, one per place in the module; `assembled` joins them.
class ProcessEmitter {
 public:
  ProcessEmitter(const Process& process, const ProcessSchedule& schedule, bool has_probes = false);
  /// A head without state: its outputs follow its inputs.
  std::string run_combinational();
  std::string run();

 private:
  struct Place {
    int block, cycle;
  };
  /// When a loop knows that it ends. Iterations that were issued before are taken back.
  struct LoopExit {
    ValueId condition = kNoValue;  ///< kNoValue: never.
    int cycle = 0;
    bool is_known_at_issue = true;
  };
  /// Blocked accesses: of plain blocks, and by loop of each of its groups of stages.
  struct Stalls {
    std::string plain;
    std::map<int, std::map<size_t, std::string>> groups;
  };
  struct PortSignals {
    std::string enable, address, data;
    std::map<int, std::string> advance;  ///< Of a far RAM: a load moves on, by stages after its address.
  };

  /// A call has ended, and its end waits to be taken.
  static constexpr const char* kCallDone = "done_q";

  // The module (emit_process.cpp)
  const Block& block_of(int block) const { return process_.blocks[block]; }
  const BlockSchedule& timing(int block) const { return schedule_.blocks[block]; }
  bool is_loop(int block) const { return block_of(block).is_loop; }
  /// A loop of a single stage is at work whenever control is there.
  bool has_stages(int block) const { return is_loop(block) && timing(block).length > 1; }
  std::string describe(int block) const;
  void emit_operation(ValueId id, int block);
  std::string assembled();
  /// When the process is done, and takes its next start.
  std::string handshake();
  std::string state_declarations() const;
  std::string loop_resets() const;
  /// Verilog wants a net declared before its use; these depend on wires that depend on them in other blocks.
  std::string forward_declarations();
  std::string data_block();
  std::string header();

  // States, pipelines and when something happens (emit_control.cpp)
  void name_states();
  const std::string& state_name(int block, int cycle) const;
  /// A block without work: control goes to its target at once.
  bool is_passed_over(int block) const;
  /// Control is at `at` in this clock; may be stalled.
  std::string active(Place at) const;
  /// The clock enable of stage `cycle`.
  std::string enable(Place at) const;
  std::string happens(Place at);
  std::string happens(const Operation& op, Place at);
  /// The last stages of the groups of stages that can stop while those behind go on; none when all stages
  /// move together. The stages behind the last split are a group, too.
  const std::vector<int>& splits(int block) const { return splits_[block]; }
  std::vector<int> find_splits(int block) const;
  /// Of a loop of calls, whose every access stops only its own call and those behind.
  std::vector<int> splits_of_calls(int block) const;
  /// Whether what a RAM has read for a stage up to `stage` stays there while those behind go on.
  bool keeps_words(int block, int stage) const;
  size_t group_of(Place at) const;
  /// The clock enable of a group of stages.
  std::string group_enable(int block, size_t group) const;
  /// Of a loop of calls with II > 1: the cycles modulo II by which the group has stopped while those behind
  /// went on. It goes on when that is 0, so that calls share the ports of memories as in the schedule.
  std::string group_slip(int block, size_t group) const;
  /// Whether any stage is at work behind those of the group, when all have moved on; empty: never.
  std::string works_behind(int block, size_t group) const;
  void emit_block(int block);
  /// Statements that bring control to block `to`, from where it ends in `from`, at the clock `when`.
  std::string go_to(int to, Place from, const std::string& when, const std::string& indent);
  /// The first values of the phis of `block`, for control that comes at the clock `when`.
  void emit_phi_starts(int block, int predecessor, Place from, const std::string& when);
  std::string transition(int block, int cycle, const std::string& when, const std::string& indent);
  std::string switch_transition(int block, int cycle, const std::string& when, const std::string& indent);
  void emit_plain_control(int block);
  void emit_loop_control(int block);
  LoopExit loop_exit(int block) const;
  /// The iteration in `cycle` is the last one; the condition must be there.
  std::string leaves(int block, int cycle);
  /// The iteration in the last stage is the last one.
  std::string is_last(int block, const LoopExit& exit);
  std::string stays(int block, int cycle);
  /// Whether the next iteration enters.
  std::string issue_of(int block, const LoopExit& exit);
  void emit_pipeline(int block, const LoopExit& exit);
  void emit_slips(int block);
  std::string transition_of_loop(int block, int cycle, const std::string& when);
  void emit_phi_updates(int block);

  // Values and the registers that carry them (emit_values.cpp)
  /// The signal that holds `id` where control is at `at`; notes the registers this takes.
  std::string signal(ValueId id, Place at);
  /// The wire of a value, or the register of a phi.
  const std::string& own_name(ValueId id) const;
  /// A pipeline carries a value in copies while the next iterations make theirs. The last cycle in which the
  /// value itself is there:
  int last_cycle(ValueId id) const;
  /// Which copy holds it in `cycle`, each for II cycles; 0: the value itself.
  int copy_of(ValueId id, int cycle) const;
  /// The phi that takes the value for the next iteration when a copy would be taken, and so holds the same;
  /// kNoValue: there is none.
  ValueId phi_with(ValueId id, int copy) const;
  std::string copy_name(ValueId id, int copy) const;
  /// The register that keeps `id` after its block.
  std::string held(ValueId id);
  /// The low `width` bits of the value.
  std::string text(ValueId id, unsigned width, Place at);
  std::string bit(ValueId id, Place at) { return text(id, 1, at); }
  bool is_constant(ValueId id) const { return process_[id].kind == OpKind::kConstant; }
  static std::string range_text_spaced(unsigned width);
  void emit_held_values();
  void emit_copies();

  // Operations as expressions (emit_expressions.cpp)
  std::string expression(ValueId id, Place at);
  bool is_all_ones(ValueId id, unsigned width) const;
  /// Factors at the widths they really have: a DSP block takes signed factors, and a tool that sees a factor
  /// extended to the product's width takes several blocks.
  std::string product(const Operation& op, Place at);
  std::string shifted_left(const Operation& op, Place at);
  std::string amount(const Operation& op, Place at);
  std::string shifted_right(const Operation& op, Place at);
  /// Bits [low + width - 1 : low] of a signal of `bits`, filled above its end.
  std::string slice(const std::string& name, unsigned bits, uint64_t low, unsigned width, bool fill_sign);
  /// A wire of its own for an expression that Verilog cannot slice.
  std::string auxiliary(const Operation& op, unsigned width, const std::string& value);
  std::string wide_slice(const Operation& op, const std::string& value, unsigned width);
  std::string concatenation(const Operation& op, Place at);
  std::string zero_extended(const Operation& op, Place at);
  std::string sign_extended(const Operation& op, Place at);
  /// A value whose representation is as wide as its type, as a number with sign of `width` bits.
  std::string sign_filled(ValueId id, unsigned width, Place at);
  std::string comparison(const Operation& op, Place at);
  /// A comparison with a power of two or 0 as a test of the bits above it; empty where it is none.
  std::string top_bits_test(const Operation& op, unsigned width, bool is_signed, Place at);
  std::string loaded(ValueId id, Place at);

  // Memories (emit_memories.cpp)
  void emit_memory(size_t index);
  /// In which order a choice asks accesses whether they use a port: those of calls from the oldest on, for a
  /// call may wait in its stage while one ahead of it goes on.
  std::vector<ValueId> in_order_of_choice(std::vector<ValueId> accesses) const;
  std::vector<ValueId> of_kind(const std::vector<ValueId>& accesses, OpKind kind) const;
  /// Enable, address and data of the one port that `users` share.
  PortSignals port_of(const Memory& memory, const std::vector<ValueId>& accesses);
  void emit_ram(const Memory& memory, const std::vector<ValueId>& accesses);
  /// Block RAM starts as zero on every target; other contents and simulation need to be told.
  void emit_initial_words(const Memory& memory, const std::string& array);
  /// A small constant table is logic; a large one is a RAM that nobody writes.
  void emit_table(const Memory& memory);
  void emit_register_memory(const Memory& memory, const std::vector<ValueId>& accesses);
  void emit_memory_port(const Memory& memory, const std::vector<ValueId>& accesses);

  // Streams and scalar ports (emit_ports.cpp)
  void emit_streams();
  void emit_enables(int block, std::map<size_t, std::string>& blocked);
  void emit_stream(int index, Stalls& stalls);
  void emit_stream_port(const Stream& stream, const std::string& strobe, const std::string& data);
  void emit_outputs();

  // What a co-simulation is told (emit_probes.cpp)
  std::string probes();
  /// The mean interval between the iterations of a pipelined loop; of calls while they wait for nothing.
  std::string loop_probe(int block);
  /// Whether the accesses of an array with DEPENDENCE inter false keep the order of the program.
  std::string dependence_probe(int block, int memory);

  const Process& process_;
  const ProcessSchedule& schedule_;
  const std::map<ValueId, ValueId> shared_phis_;
  const bool has_probes_;
  std::vector<std::vector<int>> splits_;  ///< By block.
  NameTable names_;
  std::vector<std::string> states_;
  std::vector<std::vector<std::string>> state_names_;  ///< By block and cycle.
  std::map<ValueId, int> copies_;
  std::set<ValueId> held_;
  std::map<int, std::vector<ValueId>> accesses_, stream_accesses_, outputs_;
  std::map<ValueId, std::string> blocked_;  ///< When a stream access cannot go on.
  std::ostringstream ports_, registers_, functions_, wires_, stalls_, bodies_, control_, cases_, phi_starts_,
      resets_, data_, data_resets_;
};

}  // namespace hlsc

#endif
