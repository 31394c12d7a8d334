#include <algorithm>

#include "verilog/process_emitter.h"
#include "verilog/text.h"

namespace hlsc {
namespace {

constexpr int kFewStages = 5;

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

}  // namespace

void ProcessEmitter::name_states() {
  for (const char* own : {"S_IDLE", "S_DONE"}) names_.unique(own);
  states_.push_back("S_IDLE");
  for (size_t block = 0; block < process_.blocks.size(); ++block) {
    state_names_.emplace_back();
    if (is_passed_over(block)) continue;
    int count = is_loop(block) ? 1 : timing(block).length;
    std::string stem = "S_" + upper(block_of(block).name);
    for (int cycle = 0; cycle < count; ++cycle)
      state_names_[block].push_back(names_.unique(count == 1 ? stem : stem + "_" + std::to_string(cycle)));
    states_.insert(states_.end(), state_names_[block].begin(), state_names_[block].end());
  }
  if (process_.call_loop() < 0) states_.push_back("S_DONE");
}

const std::string& ProcessEmitter::state_name(int block, int cycle) const {
  return state_names_.at(block).at(is_loop(block) ? 0 : cycle);
}

bool ProcessEmitter::is_passed_over(int block) const {
  const Block& b = block_of(block);
  return b.operations.empty() && !b.is_loop &&
         (b.terminator.kind == Terminator::kJump || b.terminator.kind == Terminator::kReturn);
}

std::string ProcessEmitter::active(Place at) const {
  if (has_stages(at.block)) return block_of(at.block).name + "_active[" + std::to_string(at.cycle) + "]";
  return "(state == " + state_name(at.block, at.cycle) + ")";
}

std::string ProcessEmitter::enable(Place at) const {
  if (!is_loop(at.block)) return "~stall";
  return group_enable(at.block, group_of(at));
}

std::string ProcessEmitter::happens(Place at) { return active(at) + " & " + enable(at); }

std::string ProcessEmitter::happens(const Operation& op, Place at) {
  std::string condition = happens(at);
  return op.predicate == kNoValue ? condition : condition + " & " + bit(op.predicate, at);
}

std::vector<int> ProcessEmitter::find_splits(int block) const {
  if (!is_loop(block)) return {};
  if (block_of(block).takes_calls) return splits_of_calls(block);
  int last = -1;
  for (ValueId id : block_of(block).operations)
    if (process_[id].kind == OpKind::kRead) last = std::max(last, schedule_.start[id]);
  bool goes_on = timing(block).ii == 1 && last >= 0 && last < timing(block).length - 1;
  return goes_on ? std::vector<int>{last} : std::vector<int>{};
}

std::vector<int> ProcessEmitter::splits_of_calls(int block) const {
  std::set<int> stages = {0};  // Where a call waits for its start.
  for (ValueId id : block_of(block).operations)
    if (process_[id].is_stream_access()) stages.insert(schedule_.start[id]);
  std::erase_if(stages, [&](int stage) {
    return stage == timing(block).length - 1 || (timing(block).ii > 1 && !keeps_words(block, stage));
  });
  return {stages.begin(), stages.end()};
}

bool ProcessEmitter::keeps_words(int block, int stage) const {
  const std::vector<ValueId>& operations = block_of(block).operations;
  auto shares_port = [&](ValueId load, ValueId other) {
    const Operation &a = process_[load], &b = process_[other];
    return b.is_memory_access() && a.object == b.object && schedule_.port[load] == schedule_.port[other];
  };
  return std::none_of(operations.begin(), operations.end(), [&](ValueId load) {
    bool is_there = process_[load].kind == OpKind::kLoad && schedule_.ready[load] > schedule_.start[load] &&
                    schedule_.start[load] < stage;
    return is_there && std::any_of(operations.begin(), operations.end(), [&](ValueId other) {
             return shares_port(load, other) && schedule_.start[other] > stage;
           });
  });
}

size_t ProcessEmitter::group_of(Place at) const {
  const std::vector<int>& last = splits(at.block);
  return std::lower_bound(last.begin(), last.end(), at.cycle) - last.begin();
}

std::string ProcessEmitter::group_enable(int block, size_t group) const {
  const std::string& name = block_of(block).name;
  const std::vector<int>& last = splits(block);
  if (group == last.size()) return name + "_ce";
  return block_of(block).takes_calls ? name + "_ce_" + std::to_string(last[group]) : name + "_front_ce";
}

std::string ProcessEmitter::group_slip(int block, size_t group) const {
  return block_of(block).name + "_slip_" + std::to_string(splits(block)[group]);
}

std::string ProcessEmitter::works_behind(int block, size_t group) const {
  int first = splits(block)[group] + 1, last = timing(block).length - 2;
  if (timing(block).ii == 1 || last < first) return "";
  return "(|" + block_of(block).name + "_active[" + std::to_string(last) + ":" + std::to_string(first) + "])";
}

void ProcessEmitter::emit_block(int block) {
  if (is_passed_over(block)) return;
  wires_ << "\n    // " << describe(block) << "\n";
  for (ValueId id : block_of(block).operations) emit_operation(id, block);
  if (is_loop(block))
    emit_loop_control(block);
  else
    emit_plain_control(block);
}

std::string ProcessEmitter::go_to(int to, Place from, const std::string& when, const std::string& indent) {
  int source = from.block;
  while (is_passed_over(to)) {
    if (block_of(to).terminator.kind == Terminator::kReturn) return indent + "state <= S_DONE;\n";
    source = to;
    to = block_of(to).terminator.targets[0];
  }
  emit_phi_starts(to, source, from, when);
  std::string out = indent + "state <= " + state_name(to, 0) + ";\n";
  if (has_stages(to)) out += indent + active({to, 0}) + " <= 1'b1;\n";
  return out;
}

/// Beside the case of the states, not in it: a start of 0 is then seen to be a register's reset, for nothing.
void ProcessEmitter::emit_phi_starts(int block, int predecessor, Place from, const std::string& when) {
  std::string starts;
  for (ValueId id : block_of(block).operations) {
    const Operation& phi = process_[id];
    if (phi.kind != OpKind::kPhi) break;
    for (size_t k = 0; k < phi.operands.size(); ++k)
      if (block_of(block).predecessors[k] == predecessor)
        starts += "            " + own_name(id) + " <= " + text(phi.operands[k], phi.bits, from) + ";\n";
  }
  if (!starts.empty()) phi_starts_ << "        if (" << when << ") begin\n" << starts << "        end\n";
}

std::string ProcessEmitter::transition(int block, int cycle, const std::string& when,
                                       const std::string& indent) {
  const Terminator& terminator = block_of(block).terminator;
  Place at{block, cycle};
  switch (terminator.kind) {
    case Terminator::kReturn:
      return indent + "state <= S_DONE;\n";
    case Terminator::kJump:
      return go_to(terminator.targets[0], at, when, indent);
    case Terminator::kBranch: {
      std::string condition = bit(terminator.condition, at);
      return indent + "if (" + condition + ") begin\n" +
             go_to(terminator.targets[0], at, when + " & " + condition, indent + "    ") + indent +
             "end else begin\n" +
             go_to(terminator.targets[1], at, when + " & ~" + condition, indent + "    ") + indent + "end\n";
    }
    default:
      return switch_transition(block, cycle, when, indent);
  }
}

std::string ProcessEmitter::switch_transition(int block, int cycle, const std::string& when,
                                              const std::string& indent) {
  const Terminator& terminator = block_of(block).terminator;
  Place at{block, cycle};
  // The condition may stand for a narrower one, of which it is a copy: the cases know their width.
  unsigned width = terminator.cases.empty() ? 1 : terminator.cases[0].getBitWidth();
  std::string value = text(terminator.condition, width, at), none = when;
  std::string out = indent + "case (" + value + ")\n";
  for (size_t i = 0; i < terminator.cases.size(); ++i) {
    std::string number = literal_text(terminator.cases[i], width);
    none += " & (" + value + " != " + number + ")";
    out += indent + "    " + number + ": begin\n" +
           go_to(terminator.targets[i + 1], at, when + " & (" + value + " == " + number + ")",
                 indent + "        ") +
           indent + "    end\n";
  }
  out += indent + "    default: begin\n" + go_to(terminator.targets[0], at, none, indent + "        ") +
         indent + "    end\n" + indent + "endcase\n";
  return out;
}

void ProcessEmitter::emit_plain_control(int block) {
  int length = timing(block).length;
  for (int cycle = 0; cycle < length; ++cycle) {
    std::string next = cycle + 1 < length
                           ? "                state <= " + state_name(block, cycle + 1) + ";\n"
                           : transition(block, cycle, happens({block, cycle}), "                ");
    cases_ << "            " << state_name(block, cycle) << ": if (~stall) begin\n"
           << next << "            end\n";
  }
}

void ProcessEmitter::emit_loop_control(int block) {
  const Block& loop = block_of(block);
  LoopExit exit = loop_exit(block);
  if (has_stages(block))
    registers_ << "    reg " << range_text_spaced(timing(block).length) << loop.name
               << "_active;  // stages at work\n";
  if (!exit.is_known_at_issue)
    wires_ << "    wire " << loop.name << "_leave = " << happens({block, exit.cycle}) << " & "
           << leaves(block, exit.cycle) << ";\n";
  if (has_stages(block)) emit_pipeline(block, exit);
  if (loop.takes_calls) emit_slips(block);
  // The iteration that leaves is the last one; when it ends, the pipeline is empty.
  int last = timing(block).length - 1;
  if (exit.condition == kNoValue) {
    cases_ << "            " << state_name(block, 0) << ": ;  // runs for ever\n";
  } else {
    std::string when = happens({block, last}) + " & " + is_last(block, exit);
    std::string next = transition_of_loop(block, last, when);
    cases_ << "            " << state_name(block, 0) << ": if (" << when << ") begin\n"
           << next << "            end\n";
  }
  emit_phi_updates(block);
}

ProcessEmitter::LoopExit ProcessEmitter::loop_exit(int block) const {
  const Terminator& terminator = block_of(block).terminator;
  LoopExit exit;
  if (terminator.kind == Terminator::kBranch) exit.condition = terminator.condition;
  if (exit.condition != kNoValue && process_[exit.condition].block == block)
    exit.cycle = schedule_.ready[exit.condition];
  exit.is_known_at_issue = exit.cycle < timing(block).ii;
  return exit;
}

std::string ProcessEmitter::leaves(int block, int cycle) {
  const Terminator& terminator = block_of(block).terminator;
  return (terminator.targets[0] == block ? "~" : "") + bit(terminator.condition, {block, cycle});
}

/// Until an iteration leaves, there is one in the first II stages: behind the last one there is none. One LUT
/// sees that of a few stages; along more of them the condition is carried.
std::string ProcessEmitter::is_last(int block, const LoopExit& exit) {
  int last = timing(block).length - 1;
  if (last == exit.cycle || last < timing(block).ii || last > kFewStages) return leaves(block, last);
  if (last == 1) return "~" + active({block, 0});
  return "~|" + block_of(block).name + "_active[" + std::to_string(last - 1) + ":0]";
}

std::string ProcessEmitter::stays(int block, int cycle) {
  const Terminator& terminator = block_of(block).terminator;
  if (terminator.kind != Terminator::kBranch) return "1'b1";
  return (terminator.targets[0] == block ? "" : "~") + bit(terminator.condition, {block, cycle});
}

std::string ProcessEmitter::issue_of(int block, const LoopExit& exit) {
  int last = timing(block).ii - 1;
  std::string issue = active({block, last});
  return issue +
         (exit.is_known_at_issue ? " & " + stays(block, last) : " & ~" + block_of(block).name + "_leave");
}

/// The stages of a group stop when any access there is blocked; those behind go on with bubbles.
void ProcessEmitter::emit_pipeline(int block, const LoopExit& exit) {
  const std::string& name = block_of(block).name;
  const std::vector<int>& last = splits(block);
  const std::string kill = name + "_leave", indent = "            ";
  auto stage = [&](int cycle) { return active({block, cycle}); };
  int cycle = 0;
  for (size_t group = 0; group <= last.size(); ++group) {
    const int end = group < last.size() ? last[group] + 1 : timing(block).length;
    control_ << (group ? "\n" : "") << "        if (" << group_enable(block, group) << ") begin\n";
    if (group == 0) control_ << indent << stage(cycle++) << " <= " << issue_of(block, exit) << ";\n";
    for (; cycle < end; ++cycle) {
      control_ << indent << stage(cycle) << " <= " << stage(cycle - 1);
      if (group_of({block, cycle - 1}) != group) control_ << " & " << enable({block, cycle - 1});
      if (!exit.is_known_at_issue && cycle - 1 < exit.cycle) control_ << " & ~" << kill;
      control_ << ";\n";
    }
    control_ << "        end";
    if (group == last.size() || exit.is_known_at_issue) continue;
    control_ << " else if (" << kill << ") begin\n"
             << indent
             << (end > 1
                     ? name + "_active[" + std::to_string(end - 1) + ":0] <= " + std::to_string(end) + "'d0"
                     : stage(0) + " <= 1'b0")
             << ";\n        end";
  }
  control_ << "\n";
}

void ProcessEmitter::emit_slips(int block) {
  const int ii = timing(block).ii;
  const std::string bits = std::to_string(address_bits(ii)) + "'d", none = bits + "0";
  for (size_t group = 0; group < splits(block).size(); ++group) {
    const std::string behind = works_behind(block, group), slip = group_slip(block, group);
    if (behind.empty()) continue;
    registers_ << "    reg " << range_text_spaced(address_bits(ii)) << slip << ";\n";
    control_ << "        if (" << group_enable(block, group + 1) << ") " << slip
             << " <= " << group_enable(block, group) << " | ~" << behind << " | (" << slip << " == " << bits
             << ii - 1 << ") ? " << none << " : " << slip << " + " << bits << "1;\n";
    resets_ << "            " << slip << " <= " << none << ";\n";
  }
}

std::string ProcessEmitter::transition_of_loop(int block, int cycle, const std::string& when) {
  const Terminator& terminator = block_of(block).terminator;
  int target = terminator.targets[0] == block ? terminator.targets[1] : terminator.targets[0];
  return go_to(target, {block, cycle}, when, "                ");
}

void ProcessEmitter::emit_phi_updates(int block) {
  for (ValueId id : block_of(block).operations) {
    const Operation& phi = process_[id];
    if (phi.kind != OpKind::kPhi) continue;
    for (size_t k = 0; k < phi.operands.size(); ++k) {
      if (block_of(block).predecessors[k] != block || phi.operands[k] == id) continue;
      Place at{block, schedule_.start[id] + timing(block).ii - 1};
      at.cycle = std::min(at.cycle, timing(block).length - 1);
      control_ << "        if (" << happens(at) << ") " << own_name(id)
               << " <= " << text(phi.operands[k], phi.bits, at) << ";\n";
    }
  }
}

}  // namespace hlsc
