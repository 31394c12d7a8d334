#include "verilog/emit_process.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "design/names.h"
#include "verilog/text.h"

namespace hlsc {
namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string base_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

class ProcessEmitter {
 public:
  ProcessEmitter(const Process& process, const ProcessSchedule& schedule)
      : process_(process), schedule_(schedule) {
    for (const Operation& op : process.operations)
      if (!op.name.empty()) names_.unique(op.name);
    for (const Memory& memory : process.memories) names_.unique(memory.name);
    for (const Block& block : process.blocks) names_.unique(block.name);
  }

  /// A head without state: its outputs follow its inputs.
  std::string run_combinational() {
    for (ValueId id : block_of(0).operations) emit_operation(id, 0);
    for (const ScalarPort& port : process_.scalars)
      ports_ << (ports_.str().empty() ? "" : ",\n") << (port.is_output ? "    output wire" : "    input wire")
             << range_text(port.width) << " " << port.name;
    for (size_t index = 0; index < process_.scalars.size(); ++index)
      for (ValueId id : outputs_[index])
        bodies_ << "    assign " << process_.scalars[index].name << " = "
                << text(process_[id].operands[0], process_.scalars[index].width, {0, 0}) << ";\n";
    std::ostringstream out;
    out << header() << "`default_nettype none\n\nmodule " << process_.name << " (\n"
        << ports_.str() << "\n);\n\n";
    out << functions_.str() << wires_.str() << "\n"
        << bodies_.str() << "\nendmodule\n\n`default_nettype wire\n";
    return out.str();
  }

  std::string run() {
    name_states();
    for (size_t block = 0; block < process_.blocks.size(); ++block) emit_block(block);
    for (size_t memory = 0; memory < process_.memories.size(); ++memory) emit_memory(memory);
    emit_streams();
    emit_outputs();
    return assembled();
  }

 private:
  const Block& block_of(int block) const { return process_.blocks[block]; }
  const BlockSchedule& timing(int block) const { return schedule_.blocks[block]; }
  bool is_loop(int block) const { return block_of(block).is_loop; }

  // --- States ---

  void name_states() {
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

  const std::string& state_name(int block, int cycle) const {
    return state_names_.at(block).at(is_loop(block) ? 0 : cycle);
  }

  /// A block without work: control goes to its target at once.
  bool is_passed_over(int block) const {
    const Block& b = block_of(block);
    return b.operations.empty() && !b.is_loop &&
           (b.terminator.kind == Terminator::kJump || b.terminator.kind == Terminator::kReturn);
  }

  // --- Values ---

  struct Place {
    int block, cycle;
  };

  bool is_wire_memory(const Memory& memory) const { return memory.load_latency == 0; }

  /// The signal that holds `id` where control is at `at`; notes the registers this takes.
  std::string signal(ValueId id, Place at) {
    const Operation& op = process_[id];
    if (op.kind == OpKind::kInput) return process_.scalars[op.object].name;
    if (op.block != at.block) return held(id);
    int ready = schedule_.ready[id];
    if (is_loop(at.block)) {
      if (at.cycle <= ready) return op.name;
      int& last = last_stage_[id];
      last = std::max(last, at.cycle);
      return op.name + "_s" + std::to_string(at.cycle);
    }
    if (op.kind == OpKind::kPhi || at.cycle <= ready) return op.name;
    return held(id);
  }

  /// The register that keeps `id` after its block.
  std::string held(ValueId id) {
    const Operation& op = process_[id];
    if (op.kind == OpKind::kPhi && !is_loop(op.block)) return op.name;
    held_.insert(id);
    return op.name + "_q";
  }

  /// The low `width` bits of the value.
  std::string text(ValueId id, unsigned width, Place at) {
    const Operation& op = process_[id];
    if (op.kind == OpKind::kConstant) {
      llvm::APInt value = op.is_signed ? op.constant.sextOrTrunc(width) : op.constant.zextOrTrunc(width);
      return literal_text(value, width);
    }
    return resized_text(signal(id, at), op.bits, op.is_signed, width);
  }
  std::string bit(ValueId id, Place at) { return text(id, 1, at); }

  bool is_constant(ValueId id) const { return process_[id].kind == OpKind::kConstant; }

  std::string expression(const Operation& op, Place at) {
    unsigned w = op.bits;
    auto operand = [&](size_t i, unsigned width) { return text(op.operands[i], width, at); };
    switch (op.kind) {
      case OpKind::kAdd:
        return operand(0, w) + " + " + operand(1, w);
      case OpKind::kSub:
        return operand(0, w) + " - " + operand(1, w);
      case OpKind::kMul:
        return product(op, at);
      case OpKind::kUDiv:
        return operand(0, w) + " / " + operand(1, w);
      case OpKind::kURem:
        return operand(0, w) + " % " + operand(1, w);
      case OpKind::kAnd:
        return operand(0, w) + " & " + operand(1, w);
      case OpKind::kOr:
        return operand(0, w) + " | " + operand(1, w);
      case OpKind::kXor:
        return is_all_ones(op.operands[1], w) ? "~" + operand(0, w) : operand(0, w) + " ^ " + operand(1, w);
      case OpKind::kShl:
        return shifted_left(op, at);
      case OpKind::kLShr:
      case OpKind::kAShr:
        return shifted_right(op, at);
      case OpKind::kSelect:
        return operand(0, 1) + " ? " + operand(1, w) + " : " + operand(2, w);
      case OpKind::kZExt:
        return zero_extended(op, at);
      case OpKind::kSExt:
        return sign_extended(op, at);
      case OpKind::kTrunc:
        return operand(0, w);
      case OpKind::kCompare:
        return comparison(op, at);
      case OpKind::kRead:
        return process_.streams[op.object].name + "_dout";
      case OpKind::kEmpty:
        return "~" + process_.streams[op.object].name + "_empty_n";
      case OpKind::kFull:
        return "~" + process_.streams[op.object].name + "_full_n";
      case OpKind::kLoad:
        return loaded(op, at);
      default:
        throw CompileError(op.location,
                           "this operation has no Verilog form yet; write it with + - * and shifts");
    }
  }

  bool is_all_ones(ValueId id, unsigned width) const {
    return is_constant(id) && process_[id].constant.sextOrTrunc(width).isAllOnes();
  }

  /// Factors at the widths they really have: a DSP block takes signed factors, and a tool that sees a factor
  /// extended to the product's width takes several blocks.
  std::string product(const Operation& op, Place at) {
    const Operation &a = process_[op.operands[0]], &b = process_[op.operands[1]];
    bool is_signed = (a.is_signed && a.bits < op.bits) || (b.is_signed && b.bits < op.bits);
    auto factor = [&](ValueId id) {
      const Operation& value = process_[id];
      unsigned width = std::min(value.bits, op.bits);
      if (!is_signed) return text(id, width, at);
      bool needs_zero = !value.is_signed && value.bits < op.bits;
      return "$signed(" + text(id, width + (needs_zero ? 1 : 0), at) + ")";
    };
    return factor(op.operands[0]) + " * " + factor(op.operands[1]);
  }

  std::string shifted_left(const Operation& op, Place at) {
    if (!is_constant(op.operands[1])) return text(op.operands[0], op.bits, at) + " << " + amount(op, at);
    uint64_t count = process_[op.operands[1]].constant.getLimitedValue(op.bits);
    if (count == 0) return text(op.operands[0], op.bits, at);
    if (count >= op.bits) return std::to_string(op.bits) + "'d0";
    return "{" + text(op.operands[0], op.bits - count, at) + ", " + std::to_string(count) + "'d0}";
  }

  std::string amount(const Operation& op, Place at) {
    const Operation& count = process_[op.operands[1]];
    return text(op.operands[1], count.is_signed ? count.type_width : count.bits, at);
  }

  std::string shifted_right(const Operation& op, Place at) {
    const Operation& value = process_[op.operands[0]];
    bool arithmetic = op.kind == OpKind::kAShr;
    // Signed representations have copies of the sign up to the type's width.
    unsigned source = value.is_signed && !arithmetic ? op.type_width : value.bits;
    bool fill_sign = arithmetic && (value.is_signed || value.bits == op.type_width);
    if (!is_constant(op.operands[1])) {
      unsigned width = std::max(source, op.bits);
      std::string from = text(op.operands[0], width, at);
      if (fill_sign && !value.is_signed) from = sign_filled(op.operands[0], width, at);
      std::string result =
          fill_sign ? "$signed(" + from + ") >>> " + amount(op, at) : from + " >> " + amount(op, at);
      return width == op.bits ? result : wide_slice(op, result, width, fill_sign);
    }
    uint64_t count = process_[op.operands[1]].constant.getLimitedValue(op.type_width);
    if (count == 0) return text(op.operands[0], op.bits, at);
    if (is_constant(op.operands[0])) {
      const llvm::APInt& constant = process_[op.operands[0]].constant;
      return literal_text(
          (arithmetic ? constant.ashr(count) : constant.lshr(count)).trunc(std::min(op.bits, op.type_width)),
          op.bits);
    }
    std::string name = signal(op.operands[0], at);
    unsigned top =
        value.is_signed || fill_sign ? std::min<unsigned>(count + op.bits, op.type_width) : value.bits;
    if (top > value.bits) {  // Needs bits above the representation.
      std::string wide =
          auxiliary(op, top, resized_text(name, value.bits, value.is_signed || fill_sign, top));
      return slice(wide, top, count, op.bits, fill_sign || (value.is_signed && arithmetic));
    }
    return slice(name, value.bits, count, op.bits, fill_sign || (value.is_signed && arithmetic));
  }

  /// Bits [low + width - 1 : low] of a signal of `bits`, filled above its end.
  std::string slice(const std::string& name, unsigned bits, uint64_t low, unsigned width, bool fill_sign) {
    if (low >= bits)
      return fill_sign ? resized_text(bits == 1 ? name : name + "[" + std::to_string(bits - 1) + "]", 1, true,
                                      width)
                       : std::to_string(width) + "'d0";
    unsigned high = std::min<uint64_t>(low + width, bits) - 1;
    std::string part = bits == 1     ? name
                       : high == low ? name + "[" + std::to_string(low) + "]"
                                     : name + "[" + std::to_string(high) + ":" + std::to_string(low) + "]";
    unsigned have = high - low + 1;
    if (have == width) return part;
    std::string count = std::to_string(width - have);
    if (!fill_sign) return "{" + count + "'d0, " + part + "}";
    std::string sign = bits == 1 ? name : name + "[" + std::to_string(bits - 1) + "]";
    return "{{" + count + "{" + sign + "}}, " + part + "}";
  }

  /// A wire of its own for an expression that Verilog cannot slice.
  std::string auxiliary(const Operation& op, unsigned width, const std::string& value) {
    std::string name = names_.unique(op.name + "_wide");
    wires_ << "    wire" << range_text(width) << " " << name << " = " << value << ";\n";
    return name;
  }
  std::string wide_slice(const Operation& op, const std::string& value, unsigned width, bool) {
    std::string name = auxiliary(op, width, value);
    return name + (op.bits == 1 ? "[0]" : "[" + std::to_string(op.bits - 1) + ":0]");
  }

  std::string zero_extended(const Operation& op, Place at) {
    unsigned low = std::min(op.bits, op.operand_width);
    std::string part = text(op.operands[0], low, at);
    return low == op.bits ? part : "{" + std::to_string(op.bits - low) + "'d0, " + part + "}";
  }

  std::string sign_extended(const Operation& op, Place at) {
    const Operation& source = process_[op.operands[0]];
    if (source.is_signed || source.bits < op.operand_width || op.bits <= source.bits)
      return text(op.operands[0], op.bits, at);
    return sign_filled(op.operands[0], op.bits, at);
  }

  /// A value whose representation is as wide as its type, as a number with sign of `width` bits.
  std::string sign_filled(ValueId id, unsigned width, Place at) {
    const Operation& op = process_[id];
    if (op.kind == OpKind::kConstant) return literal_text(op.constant.sextOrTrunc(width), width);
    return resized_text(signal(id, at), op.bits, true, width);
  }

  std::string comparison(const Operation& op, Place at) {
    const Operation &a = process_[op.operands[0]], &b = process_[op.operands[1]];
    auto bits_as = [&](const Operation& value, bool as_signed) {
      return as_signed && !value.is_signed && value.bits < op.operand_width ? value.bits + 1 : value.bits;
    };
    bool is_equality = op.compare == CompareKind::kEq || op.compare == CompareKind::kNe;
    bool compares_signed = op.compare >= CompareKind::kSLt;
    bool any_signed = a.is_signed || b.is_signed;
    unsigned width;
    bool use_signed = false;
    if (is_equality) {
      width = std::min(op.operand_width, std::max(bits_as(a, any_signed), bits_as(b, any_signed)));
    } else if (compares_signed) {
      bool plain = !any_signed && a.bits < op.operand_width && b.bits < op.operand_width;
      use_signed = !plain;
      width = plain ? std::max(a.bits, b.bits)
                    : std::min(op.operand_width, std::max(bits_as(a, true), bits_as(b, true)));
    } else {
      width = any_signed ? op.operand_width : std::max(a.bits, b.bits);
    }
    std::string left = text(op.operands[0], width, at), right = text(op.operands[1], width, at);
    if (use_signed) {
      left = "$signed(" + left + ")";
      right = "$signed(" + right + ")";
    }
    static const char* const signs[] = {"==", "!=", "<", "<=", ">", ">=", "<", "<=", ">", ">="};
    return left + " " + signs[static_cast<int>(op.compare)] + " " + right;
  }

  std::string loaded(const Operation& op, Place at) {
    const Memory& memory = process_.memories[op.object];
    std::string word;
    if (memory.load_latency > 0) {
      word = memory.name + "_q";
    } else if (memory.kind == MemoryKind::kRom) {
      word = memory.name + "_at(" + text(op.operands[0], address_bits(memory.depth), at) + ")";
      if (op.bits != memory.width) word = auxiliary(op, memory.width, word);
    } else if (memory.depth == 1) {
      word = memory.name;
    } else {
      word = memory.name + "[" + text(op.operands[0], address_bits(memory.depth), at) + "]";
      if (op.bits != memory.width) word = auxiliary(op, memory.width, word);
    }
    return resized_text(word, memory.width, memory.is_signed, op.bits);
  }

  // --- Conditions of time ---

  /// Control is at `at` in this clock; may be stalled.
  std::string active(Place at) const {
    if (is_loop(at.block))
      return block_of(at.block).name + "_active" +
             (timing(at.block).length == 1 ? "" : "[" + std::to_string(at.cycle) + "]");
    return "(state == " + state_name(at.block, at.cycle) + ")";
  }

  /// The clock enable of stage `cycle`.
  std::string enable(Place at) const {
    if (!is_loop(at.block)) return "~stall";
    return block_of(at.block).name + (at.cycle <= split_stage(at.block) ? "_front_ce" : "_ce");
  }

  std::string happens(Place at) { return active(at) + " & " + enable(at); }

  std::string happens(const Operation& op, Place at) {
    std::string condition = happens(at);
    return op.predicate == kNoValue ? condition : condition + " & " + bit(op.predicate, at);
  }

  /// Last stage with a stream read, if the stages behind it can go on without it; -1 when all stages move
  /// together.
  int split_stage(int block) const {
    if (timing(block).ii != 1) return -1;
    int last = -1;
    for (ValueId id : block_of(block).operations)
      if (process_[id].kind == OpKind::kRead) last = std::max(last, schedule_.start[id]);
    return last < timing(block).length - 1 ? last : -1;
  }

  // --- Blocks ---

  void emit_block(int block) {
    if (is_passed_over(block)) return;
    wires_ << "\n    // " << describe(block) << "\n";
    for (ValueId id : block_of(block).operations) emit_operation(id, block);
    if (is_loop(block))
      emit_loop_control(block);
    else
      emit_plain_control(block);
  }

  std::string describe(int block) const {
    const Block& b = block_of(block);
    std::ostringstream out;
    out << base_name(b.location.text()) << ": ";
    if (b.is_loop)
      out << "loop " << b.name << ", II = " << timing(block).ii << ", " << timing(block).length << " stage"
          << (timing(block).length == 1 ? "" : "s");
    else
      out << b.name;
    return out.str();
  }

  void emit_operation(ValueId id, int block) {
    const Operation& op = process_[id];
    Place at{block, schedule_.start[id]};
    if (op.kind == OpKind::kPhi) {
      registers_ << "    reg " << range_text_spaced(op.bits) << op.name << ";\n";
      return;
    }
    std::string where = op.location.line
                            ? "  // " + base_name(op.location.file) + ":" + std::to_string(op.location.line)
                            : "";
    if (op.is_memory_access()) accesses_[op.object].push_back(id);
    if (op.is_stream_access()) stream_accesses_[op.object].push_back(id);
    if (op.kind == OpKind::kOutput) outputs_[op.object].push_back(id);
    if (!op.has_result()) return;
    std::string value = expression(op, {block, schedule_.ready[id]});
    if (op.kind == OpKind::kLoad) value = expression(op, at);
    wires_ << "    wire " << range_text_spaced(op.bits) << op.name << " = " << value << ";" << where << "\n";
  }

  static std::string range_text_spaced(unsigned width) {
    return width == 1 ? "" : range_text(width).substr(1) + " ";
  }

  /// Statements that bring control from the end of block `from` to `to`.
  std::string go_to(int to, int from, int from_cycle, const std::string& indent) {
    int source = from;
    while (is_passed_over(to)) {
      if (block_of(to).terminator.kind == Terminator::kReturn) return indent + "state <= S_DONE;\n";
      source = to;
      to = block_of(to).terminator.targets[0];
    }
    std::string out = indent + "state <= " + state_name(to, 0) + ";\n";
    if (is_loop(to))
      out += indent + block_of(to).name + "_active" + (timing(to).length == 1 ? "" : "[0]") + " <= 1'b1;\n";
    for (ValueId id : block_of(to).operations) {
      const Operation& phi = process_[id];
      if (phi.kind != OpKind::kPhi) break;
      for (size_t k = 0; k < phi.operands.size(); ++k)
        if (block_of(to).predecessors[k] == source)
          phi_starts_[to].push_back(indent + phi.name +
                                    " <= " + text(phi.operands[k], phi.bits, {from, from_cycle}) + ";\n");
    }
    for (const std::string& line : phi_starts_[to]) out += line;
    phi_starts_[to].clear();
    return out;
  }

  std::string transition(int block, int cycle, const std::string& indent) {
    const Terminator& terminator = block_of(block).terminator;
    Place at{block, cycle};
    switch (terminator.kind) {
      case Terminator::kReturn:
        return indent + "state <= S_DONE;\n";
      case Terminator::kJump:
        return go_to(terminator.targets[0], block, cycle, indent);
      case Terminator::kBranch:
        return indent + "if (" + bit(terminator.condition, at) + ") begin\n" +
               go_to(terminator.targets[0], block, cycle, indent + "    ") + indent + "end else begin\n" +
               go_to(terminator.targets[1], block, cycle, indent + "    ") + indent + "end\n";
      case Terminator::kSwitch:
        break;
    }
    unsigned width = process_[terminator.condition].type_width;
    std::string out = indent + "case (" + text(terminator.condition, width, at) + ")\n";
    for (size_t i = 0; i < terminator.cases.size(); ++i)
      out += indent + "    " + literal_text(terminator.cases[i], width) + ": begin\n" +
             go_to(terminator.targets[i + 1], block, cycle, indent + "        ") + indent + "    end\n";
    out += indent + "    default: begin\n" + go_to(terminator.targets[0], block, cycle, indent + "        ") +
           indent + "    end\n" + indent + "endcase\n";
    return out;
  }

  void emit_plain_control(int block) {
    int length = timing(block).length;
    for (int cycle = 0; cycle < length; ++cycle) {
      std::string next = cycle + 1 < length
                             ? "                state <= " + state_name(block, cycle + 1) + ";\n"
                             : transition(block, cycle, "                ");
      cases_ << "            " << state_name(block, cycle) << ": if (~stall) begin\n"
             << next << "            end\n";
    }
  }

  void emit_loop_control(int block) {
    const Block& loop = block_of(block);
    int length = timing(block).length, ii = timing(block).ii;
    const std::string& name = loop.name;
    bool single = length == 1;
    registers_ << "    reg " << range_text_spaced(length) << name << "_active;  // stages at work\n";

    int leave_cycle = 0;
    ValueId condition = loop.terminator.kind == Terminator::kBranch ? loop.terminator.condition : kNoValue;
    bool stays_when_true = condition == kNoValue || loop.terminator.targets[0] == block;
    if (condition != kNoValue && process_[condition].block == block) leave_cycle = schedule_.ready[condition];
    auto leaves = [&](int cycle) {
      return condition == kNoValue ? std::string("1'b0")
                                   : (stays_when_true ? "~" : "") + bit(condition, {block, cycle});
    };
    auto stays = [&](int cycle) {
      return condition == kNoValue ? std::string("1'b1")
                                   : (stays_when_true ? "" : "~") + bit(condition, {block, cycle});
    };
    auto stage = [&](int cycle) {
      return name + "_active" + (single ? "" : "[" + std::to_string(cycle) + "]");
    };

    bool known_in_time = leave_cycle < ii;
    std::string next = stage(ii - 1);
    if (known_in_time) next += " & " + stays(ii - 1);
    std::string kill = name + "_leave";
    if (!known_in_time) {
      wires_ << "    wire " << kill << " = " << happens({block, leave_cycle}) << " & " << leaves(leave_cycle)
             << ";\n";
      next += " & ~" + kill;
    }

    // Stages up to the split stop when any access there is blocked; those behind go on with bubbles.
    int split = split_stage(block);
    std::ostringstream steps;
    auto step = [&](int to) {
      std::string value = stage(to - 1);
      if (to - 1 == split) value += " & " + name + "_front_ce";
      if (!known_in_time && to - 1 < leave_cycle) value += " & ~" + kill;
      return value;
    };
    if (split < 0) {
      steps << "        if (" << name << "_ce) begin\n            " << stage(0) << " <= " << next << ";\n";
      for (int to = 1; to < length; ++to) steps << "            " << stage(to) << " <= " << step(to) << ";\n";
      steps << "        end\n";
    } else {
      steps << "        if (" << name << "_front_ce) begin\n            " << stage(0) << " <= " << next
            << ";\n";
      for (int to = 1; to <= split; ++to) steps << "            " << stage(to) << " <= " << step(to) << ";\n";
      steps << "        end"
            << (known_in_time ? ""
                              : " else if (" + kill + ") begin\n            " +
                                    (split ? name + "_active[" + std::to_string(split) +
                                                 ":0] <= " + std::to_string(split + 1) + "'d0"
                                           : stage(0) + " <= 1'b0") +
                                    ";\n        end")
            << "\n";
      steps << "        if (" << name << "_ce) begin\n";
      for (int to = split + 1; to < length; ++to)
        steps << "            " << stage(to) << " <= " << step(to) << ";\n";
      steps << "        end\n";
    }
    control_ << steps.str();

    // The iteration that leaves is the last one; when it ends, the pipeline is empty.
    if (condition != kNoValue) {
      std::string exit = transition_of_loop(block, length - 1);
      cases_ << "            " << state_name(block, 0) << ": if (" << happens({block, length - 1}) << " & "
             << leaves(length - 1) << ") begin\n"
             << exit << "            end\n";
    } else {
      cases_ << "            " << state_name(block, 0) << ": ;  // runs for ever\n";
    }
    emit_phi_updates(block);
  }

  std::string transition_of_loop(int block, int cycle) {
    const Terminator& terminator = block_of(block).terminator;
    int target = terminator.targets[0] == block ? terminator.targets[1] : terminator.targets[0];
    return go_to(target, block, cycle, "                ");
  }

  void emit_phi_updates(int block) {
    for (ValueId id : block_of(block).operations) {
      const Operation& phi = process_[id];
      if (phi.kind != OpKind::kPhi) continue;
      for (size_t k = 0; k < phi.operands.size(); ++k) {
        if (block_of(block).predecessors[k] != block || phi.operands[k] == id) continue;
        Place at{block, schedule_.start[id] + timing(block).ii - 1};
        at.cycle = std::min(at.cycle, timing(block).length - 1);
        control_ << "        if (" << happens(at) << ") " << phi.name
                 << " <= " << text(phi.operands[k], phi.bits, at) << ";\n";
      }
    }
  }

  // --- Memories ---

  void emit_memory(size_t index) {
    const Memory& memory = process_.memories[index];
    std::vector<ValueId>& accesses = accesses_[index];
    if (accesses.empty()) return;
    wires_ << "\n    // memory " << memory.name << ": " << memory.depth << " x " << memory.width << "\n";
    bool is_table = memory.kind == MemoryKind::kRom && memory.load_latency == 0;
    if (is_table) emit_table(memory);
    if (memory.kind == MemoryKind::kRegisters) emit_register_memory(memory, accesses);
    if (memory.kind == MemoryKind::kRam || (memory.kind == MemoryKind::kRom && !is_table))
      emit_ram(memory, accesses);
    if (memory.kind == MemoryKind::kPort) emit_memory_port(memory, accesses);
  }

  struct PortSignals {
    std::string enable, address, data;
  };

  /// Enable, address and data of the one port that all accesses of `kind` share.
  PortSignals port_of(const Memory& memory, const std::vector<ValueId>& accesses, OpKind kind) {
    PortSignals port;
    std::vector<ValueId> users;
    for (ValueId id : accesses)
      if (process_[id].kind == kind) users.push_back(id);
    for (size_t i = 0; i < users.size(); ++i) {
      const Operation& op = process_[users[i]];
      Place at{op.block, schedule_.start[users[i]]};
      std::string when = kind == OpKind::kLoad ? happens(at) : happens(op, at);
      port.enable += (i ? " | " : "") + (users.size() > 1 ? "(" + when + ")" : when);
      std::string address = text(op.operands[0], address_bits(memory.depth), at);
      std::string data = kind == OpKind::kStore ? text(op.operands[1], memory.width, at) : "";
      std::string separator = i + 1 < users.size() ? active(at) +
                                                         (op.predicate != kNoValue && kind == OpKind::kStore
                                                              ? " & " + bit(op.predicate, at)
                                                              : "") +
                                                         " ? "
                                                   : "";
      port.address += separator + address + (separator.empty() ? "" : " : ");
      port.data += separator + data + (separator.empty() ? "" : " : ");
    }
    return port;
  }

  void emit_ram(const Memory& memory, const std::vector<ValueId>& accesses) {
    PortSignals write = port_of(memory, accesses, OpKind::kStore),
                read = port_of(memory, accesses, OpKind::kLoad);
    unsigned address = address_bits(memory.depth);
    const std::string& name = memory.name;
    if (read.enable.empty()) return;
    registers_ << "    wire" << range_text(memory.width) << " " << name << "_q;\n";
    auto or_zero = [](const std::string& value, unsigned width) {
      return value.empty() ? std::to_string(width) + "'d0" : value;
    };
    if (memory.initial.empty()) {
      bodies_ << "\n    ram_1r1w #(\n        .WIDTH(" << memory.width << "),\n        .DEPTH(" << memory.depth
              << "),\n        .ADDRESS_WIDTH(" << address << ")\n    ) " << name
              << " (\n        .clk(clk),\n        .write_enable(" << or_zero(write.enable, 1)
              << "),\n        .write_address(" << or_zero(write.address, address)
              << "),\n        .write_data(" << or_zero(write.data, memory.width)
              << "),\n        .read_enable(" << read.enable << "),\n        .read_address(" << read.address
              << "),\n        .read_data(" << name << "_q)\n    );\n";
      return;
    }
    std::string array = names_.unique(name + "_words"), q = names_.unique(name + "_read");
    bodies_ << "\n    reg" << range_text(memory.width) << " " << array << " [0:" << memory.depth - 1
            << "];\n    reg" << range_text(memory.width) << " " << q << ";\n    assign " << name
            << "_q = " << q << ";\n";
    emit_initial_words(memory, array);
    bodies_ << "    always @(posedge clk) begin\n";
    if (!write.enable.empty())
      bodies_ << "        if (" << write.enable << ") " << array << "[" << write.address
              << "] <= " << write.data << ";\n";
    bodies_ << "        if (" << read.enable << ") " << q << " <= " << array << "[" << read.address
            << "];\n    end\n";
  }

  /// Block RAM starts as zero on every target; other contents and simulation need to be told.
  void emit_initial_words(const Memory& memory, const std::string& array) {
    bool is_zero = memory.initial.size() == 1 && memory.initial[0].isZero();
    std::string index = names_.unique(memory.name + "_index");
    if (is_zero || memory.initial.size() == 1) {
      bodies_ << (is_zero ? "    // synthesis translate_off\n" : "") << "    integer " << index
              << ";\n    initial\n        for (" << index << " = 0; " << index << " < " << memory.depth
              << "; " << index << " = " << index << " + 1)\n            " << array << "[" << index
              << "] = " << literal_text(memory.initial[0].zextOrTrunc(memory.width), memory.width) << ";\n"
              << (is_zero ? "    // synthesis translate_on\n" : "");
      return;
    }
    bodies_ << "    initial begin\n";
    for (size_t i = 0; i < memory.initial.size(); ++i)
      bodies_ << "        " << array << "[" << i
              << "] = " << literal_text(memory.initial[i].trunc(memory.width), memory.width) << ";\n";
    bodies_ << "    end\n";
  }

  /// A small constant table is logic; a large one is a RAM that nobody writes.
  void emit_table(const Memory& memory) {
    unsigned address = address_bits(memory.depth);
    functions_ << "\n    function" << range_text(memory.width) << " " << memory.name << "_at;\n        input"
               << range_text(address) << " address;\n        case (address)\n";
    for (size_t i = 0; i < memory.depth; ++i) {
      const llvm::APInt& word = memory.initial.size() == 1 ? memory.initial[0] : memory.initial[i];
      functions_ << "            " << address << "'d" << i << ": " << memory.name
                 << "_at = " << literal_text(word.zextOrTrunc(memory.width), memory.width) << ";\n";
    }
    functions_ << "            default: " << memory.name << "_at = " << memory.width
               << "'d0;\n        endcase\n    endfunction\n";
  }

  void emit_register_memory(const Memory& memory, const std::vector<ValueId>& accesses) {
    bool is_array = memory.depth > 1;
    registers_ << "    reg" << range_text(memory.width) << " " << memory.name
               << (is_array ? " [0:" + std::to_string(memory.depth - 1) + "]" : "") << ";\n";
    for (ValueId id : accesses) {
      const Operation& op = process_[id];
      if (op.kind != OpKind::kStore) continue;
      Place at{op.block, schedule_.start[id]};
      std::string target =
          memory.name + (is_array ? "[" + text(op.operands[0], address_bits(memory.depth), at) + "]" : "");
      data_ << "        if (" << happens(op, at) << ") " << target
            << " <= " << text(op.operands[1], memory.width, at) << ";\n";
    }
    if (memory.initial.empty()) return;
    for (uint64_t i = 0; i < memory.depth; ++i) {
      const llvm::APInt& word = memory.initial.size() == 1 ? memory.initial[0] : memory.initial[i];
      data_resets_ << "            " << memory.name << (is_array ? "[" + std::to_string(i) + "]" : "")
                   << " <= " << literal_text(word.zextOrTrunc(memory.width), memory.width) << ";\n";
    }
  }

  void emit_memory_port(const Memory& memory, const std::vector<ValueId>& accesses) {
    PortSignals write = port_of(memory, accesses, OpKind::kStore),
                read = port_of(memory, accesses, OpKind::kLoad);
    unsigned address = address_bits(memory.depth);
    int port = 0;
    auto output = [&](const std::string& name, unsigned width, const std::string& value) {
      ports_ << ",\n    output wire" << range_text(width) << " " << name;
      bodies_ << "    assign " << name << " = " << value << ";\n";
    };
    bodies_ << "\n";
    if (!read.enable.empty()) {
      std::string q = memory.name + "_q" + std::to_string(port);
      output(memory.name + "_address" + std::to_string(port), address, read.address);
      output(memory.name + "_ce" + std::to_string(port), 1, read.enable);
      ports_ << ",\n    input wire" << range_text(memory.width) << " " << q;
      registers_ << "    wire" << range_text(memory.width) << " " << memory.name << "_q = " << q << ";\n";
      ++port;
    }
    if (!write.enable.empty()) {
      output(memory.name + "_address" + std::to_string(port), address, write.address);
      output(memory.name + "_ce" + std::to_string(port), 1, write.enable);
      output(memory.name + "_we" + std::to_string(port), 1, write.enable);
      output(memory.name + "_d" + std::to_string(port), memory.width, write.data);
    }
  }

  // --- Streams and scalar ports ---

  void emit_streams() {
    std::map<int, std::string> front, back;
    std::string plain;
    for (size_t index = 0; index < process_.streams.size(); ++index) {
      const Stream& stream = process_.streams[index];
      std::string strobe, data;
      const std::vector<ValueId>& users = stream_accesses_[index];
      for (size_t i = 0; i < users.size(); ++i) {
        const Operation& op = process_[users[i]];
        Place at{op.block, schedule_.start[users[i]]};
        std::string wish = active(at) + (op.predicate == kNoValue ? "" : " & " + bit(op.predicate, at));
        std::string blocked = wish + " & ~" + stream.name + (stream.is_input ? "_empty_n" : "_full_n");
        std::string& sum = !is_loop(op.block)                  ? plain
                           : at.cycle <= split_stage(op.block) ? front[op.block]
                                                               : back[op.block];
        sum += (sum.empty() ? "" : " | ") + ("(" + blocked + ")");
        strobe += (i ? " | " : "") + ("(" + happens(op, at) + ")");
        if (!stream.is_input) {
          std::string separator = i + 1 < users.size() ? "(" + wish + ") ? " : "";
          data += separator + text(op.operands[0], stream.width, at) + (separator.empty() ? "" : " : ");
        }
      }
      if (users.empty()) strobe = "1'b0";
      if (users.empty() && !stream.is_input) data = std::to_string(stream.width) + "'d0";
      if (stream.is_input) {
        ports_ << ",\n    input wire" << range_text(stream.width) << " " << stream.name
               << "_dout,\n    input wire " << stream.name << "_empty_n,\n    output wire " << stream.name
               << "_read";
        bodies_ << "    assign " << stream.name << "_read = " << strobe << ";\n";
      } else {
        ports_ << ",\n    output wire" << range_text(stream.width) << " " << stream.name
               << "_din,\n    input wire " << stream.name << "_full_n,\n    output wire " << stream.name
               << "_write";
        bodies_ << "    assign " << stream.name << "_write = " << strobe << ";\n    assign " << stream.name
                << "_din = " << data << ";\n";
      }
    }
    stalls_ << "    assign stall = " << (plain.empty() ? "1'b0" : plain) << ";\n";
    for (size_t block = 0; block < process_.blocks.size(); ++block) {
      if (!is_loop(block)) continue;
      const std::string& name = block_of(block).name;
      stalls_ << "    assign " << name
              << "_ce = " << (back[block].empty() ? "1'b1" : "~(" + back[block] + ")") << ";\n";
      if (split_stage(block) >= 0)
        stalls_ << "    assign " << name << "_front_ce = " << name << "_ce & ~(" << front[block] << ");\n";
    }
  }

  void emit_outputs() {
    for (size_t index = 0; index < process_.scalars.size(); ++index) {
      const ScalarPort& port = process_.scalars[index];
      if (!port.is_output) {
        ports_ << ",\n    input wire" << range_text(port.width) << " " << port.name;
        continue;
      }
      ports_ << ",\n    output reg" << range_text(port.width) << " " << port.name;
      if (port.has_valid()) ports_ << ",\n    output reg " << port.name << "_ap_vld";
      std::string any;
      for (ValueId id : outputs_[index]) {
        const Operation& op = process_[id];
        Place at{op.block, schedule_.start[id]};
        data_ << "        if (" << happens(op, at) << ") " << port.name
              << " <= " << text(op.operands[0], port.width, at) << ";\n";
        any += (any.empty() ? "" : " | ") + ("(" + happens(op, at) + ")");
      }
      if (port.has_valid())
        control_ << "        " << port.name << "_ap_vld <= " << (any.empty() ? "1'b0" : any) << ";\n";
      if (port.has_valid()) resets_ << "            " << port.name << "_ap_vld <= 1'b0;\n";
    }
  }

  // --- Registers that carry values ---

  void emit_held_values() {
    for (ValueId id : held_) {
      const Operation& op = process_[id];
      Place at{op.block, schedule_.ready[id]};
      if (is_loop(op.block)) {
        const Block& loop = block_of(op.block);
        if (loop.terminator.condition != kNoValue && process_[loop.terminator.condition].block == op.block)
          at.cycle = std::max(at.cycle, schedule_.ready[loop.terminator.condition]);
      }
      registers_ << "    reg " << range_text_spaced(op.bits) << op.name << "_q;\n";
      data_ << "        if (" << happens(at) << ") " << op.name << "_q <= " << signal(id, at) << ";\n";
    }
  }

  void emit_stages() {
    std::map<std::string, std::ostringstream> by_enable;
    std::vector<std::string> order;
    for (auto [id, last] : last_stage_) {
      const Operation& op = process_[id];
      int ready = schedule_.ready[id];
      for (int cycle = ready + 1; cycle <= last; ++cycle) {
        std::string ce = enable({op.block, cycle - 1});
        if (!by_enable.count(ce)) order.push_back(ce);
        std::string from = cycle - 1 == ready ? op.name : op.name + "_s" + std::to_string(cycle - 1);
        std::string to = op.name + "_s" + std::to_string(cycle);
        registers_ << "    reg " << range_text_spaced(op.bits) << to << ";\n";
        by_enable[ce] << "            " << to << " <= " << from << ";\n";
      }
    }
    for (const std::string& ce : order)
      data_ << "        if (" << ce << ") begin\n" << by_enable[ce].str() << "        end\n";
  }

  // --- The module ---

  std::string assembled() {
    emit_held_values();
    emit_stages();
    std::string entry = go_to(0, -1, 0, "                ");
    std::ostringstream out;
    out << header() << "`default_nettype none\n\nmodule " << process_.name << " (\n";
    out << "    input wire clk,\n    input wire rst,\n    input wire ap_start,\n    input wire "
           "ap_continue,\n";
    out << "    output wire ap_done,\n    output wire ap_idle,\n    output wire ap_ready" << ports_.str()
        << "\n);\n\n";
    out << state_declarations() << registers_.str() << functions_.str() << "\n" << forward_declarations();
    out << wires_.str() << "\n" << stalls_.str() << "\n" << bodies_.str() << "\n";
    out << "    assign ap_idle = (state == S_IDLE);\n    assign ap_done = (state == S_DONE);\n";
    out << "    assign ap_ready = ap_done & ap_continue;\n\n";
    out << "    always @(posedge clk) begin\n" << control_.str() << "        case (state)\n";
    out << "            S_IDLE: if (ap_start) begin\n" << entry << "            end\n" << cases_.str();
    out << "            S_DONE: if (ap_continue) state <= S_IDLE;\n            default: state <= S_IDLE;\n";
    out << "        endcase\n        if (rst) begin\n            state <= S_IDLE;\n"
        << loop_resets() << resets_.str();
    out << "        end\n    end\n" << data_block() << "\nendmodule\n\n`default_nettype wire\n";
    return out.str();
  }

  std::string state_declarations() const {
    int bits = address_bits(states_.size());
    std::ostringstream out;
    for (size_t i = 0; i < states_.size(); ++i)
      out << "    localparam [" << bits - 1 << ":0] " << states_[i] << " = " << bits << "'d" << i << ";\n";
    out << "    reg [" << bits - 1 << ":0] state;\n\n";
    return out.str();
  }

  std::string loop_resets() const {
    std::string out;
    for (size_t block = 0; block < process_.blocks.size(); ++block)
      if (is_loop(block))
        out += "            " + block_of(block).name + "_active <= " + std::to_string(timing(block).length) +
               "'d0;\n";
    return out;
  }

  /// Verilog wants a net declared before its use; these depend on wires that depend on them in other blocks.
  std::string forward_declarations() {
    std::string out = "    wire stall;\n";
    for (size_t block = 0; block < process_.blocks.size(); ++block) {
      if (!is_loop(block)) continue;
      out += "    wire " + block_of(block).name + "_ce;\n";
      if (split_stage(block) >= 0) out += "    wire " + block_of(block).name + "_front_ce;\n";
    }
    return out;
  }

  std::string data_block() {
    std::string body = data_.str();
    if (body.empty()) return "";
    std::string out = "\n    always @(posedge clk) begin\n" + body;
    if (!data_resets_.str().empty()) out += "        if (rst) begin\n" + data_resets_.str() + "        end\n";
    return out + "    end\n";
  }

  std::string header() {
    std::ostringstream out;
    out << "// " << process_.name << ": " << process_.source_name << " of "
        << base_name(process_.location.file) << ":" << process_.location.line
        << ". Generated by floorline-hlsc; do not edit.\n";
    for (size_t block = 0; block < process_.blocks.size(); ++block)
      if (is_loop(block)) out << "//   loop " << describe(block) << "\n";
    out << "\n";
    return out.str();
  }

  const Process& process_;
  const ProcessSchedule& schedule_;
  NameTable names_;
  std::vector<std::string> states_;
  std::vector<std::vector<std::string>> state_names_;  ///< By block and cycle.
  std::map<ValueId, int> last_stage_;
  std::set<ValueId> held_;
  std::map<int, std::vector<ValueId>> accesses_, stream_accesses_, outputs_;
  std::map<int, std::vector<std::string>> phi_starts_;
  std::ostringstream ports_, registers_, functions_, wires_, stalls_, bodies_, control_, cases_, resets_,
      data_, data_resets_;
};

}  // namespace

bool is_combinational(const Process& process) {
  if (process.blocks.size() != 1 || process.blocks[0].is_loop || !process.streams.empty()) return false;
  for (ValueId id : process.blocks[0].operations)
    if (process[id].is_memory_access() ||
        (process[id].kind == OpKind::kOutput && process.scalars[process[id].object].has_valid()))
      return false;
  return true;
}

std::string emit_combinational(const Process& process) {
  ProcessSchedule schedule;
  schedule.blocks.resize(1);
  schedule.start.assign(process.operations.size(), 0);
  schedule.ready = schedule.start;
  return ProcessEmitter(process, schedule).run_combinational();
}

std::string emit_process(const Process& process, const ProcessSchedule& schedule) {
  return ProcessEmitter(process, schedule).run();
}

}  // namespace hlsc
