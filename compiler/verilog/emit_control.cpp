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
  states_.push_back("S_DONE");
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
  return block_of(at.block).name + (at.cycle <= split_stage(at.block) ? "_front_ce" : "_ce");
}

std::string ProcessEmitter::happens(Place at) { return active(at) + " & " + enable(at); }

std::string ProcessEmitter::happens(const Operation& op, Place at) {
  std::string condition = happens(at);
  return op.predicate == kNoValue ? condition : condition + " & " + bit(op.predicate, at);
}

int ProcessEmitter::split_stage(int block) const {
  if (timing(block).ii != 1) return -1;
  int last = -1;
  for (ValueId id : block_of(block).operations)
    if (process_[id].kind == OpKind::kRead) last = std::max(last, schedule_.start[id]);
  return last < timing(block).length - 1 ? last : -1;
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

/// Stages up to the split stop when any access there is blocked; those behind go on with bubbles.
void ProcessEmitter::emit_pipeline(int block, const LoopExit& exit) {
  const std::string& name = block_of(block).name;
  int length = timing(block).length, split = split_stage(block);
  std::string kill = name + "_leave", indent = "            ";
  auto stage = [&](int cycle) { return active({block, cycle}); };
  auto steps = [&](int from, int to) {
    std::string out;
    for (int cycle = from; cycle < to; ++cycle) {
      out += indent + stage(cycle) + " <= " + stage(cycle - 1);
      if (cycle - 1 == split) out += " & " + name + "_front_ce";
      if (!exit.is_known_at_issue && cycle - 1 < exit.cycle) out += " & ~" + kill;
      out += ";\n";
    }
    return out;
  };
  std::string first = indent + stage(0) + " <= " + issue_of(block, exit) + ";\n";
  if (split < 0) {
    control_ << "        if (" << name << "_ce) begin\n" << first << steps(1, length) << "        end\n";
    return;
  }
  control_ << "        if (" << name << "_front_ce) begin\n" << first << steps(1, split + 1) << "        end";
  if (!exit.is_known_at_issue)
    control_ << " else if (" << kill << ") begin\n"
             << indent
             << (split ? name + "_active[" + std::to_string(split) + ":0] <= " + std::to_string(split + 1) +
                             "'d0"
                       : stage(0) + " <= 1'b0")
             << ";\n        end";
  control_ << "\n        if (" << name << "_ce) begin\n" << steps(split + 1, length) << "        end\n";
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
