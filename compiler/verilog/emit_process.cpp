#include "verilog/emit_process.h"

#include "design/shared_phis.h"
#include "verilog/process_emitter.h"
#include "verilog/text.h"

namespace hlsc {
namespace {

std::string base_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

}  // namespace

ProcessEmitter::ProcessEmitter(const Process& process, const ProcessSchedule& schedule, bool has_probes)
    : process_(process), schedule_(schedule), shared_phis_(shared_phis(process)), has_probes_(has_probes) {
  for (const Operation& op : process.operations)
    if (!op.name.empty()) names_.unique(op.name);
  for (const Memory& memory : process.memories) names_.unique(memory.name);
  for (const Block& block : process.blocks) names_.unique(block.name);
  for (size_t block = 0; block < process.blocks.size(); ++block) splits_.push_back(find_splits(block));
}

std::string ProcessEmitter::run_combinational() {
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

std::string ProcessEmitter::run() {
  name_states();
  for (size_t block = 0; block < process_.blocks.size(); ++block) emit_block(block);
  for (size_t memory = 0; memory < process_.memories.size(); ++memory) emit_memory(memory);
  emit_streams();
  emit_outputs();
  return assembled();
}

std::string ProcessEmitter::describe(int block) const {
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

void ProcessEmitter::emit_operation(ValueId id, int block) {
  const Operation& op = process_[id];
  Place at{block, schedule_.start[id]};
  if (op.kind == OpKind::kInput) return;
  if (op.kind == OpKind::kPhi) {
    if (!shared_phis_.count(id)) registers_ << "    reg " << range_text_spaced(op.bits) << op.name << ";\n";
    return;
  }
  std::string where =
      op.location.line ? "  // " + base_name(op.location.file) + ":" + std::to_string(op.location.line) : "";
  if (op.is_memory_access()) accesses_[op.object].push_back(id);
  if (op.is_stream_access()) stream_accesses_[op.object].push_back(id);
  if (op.kind == OpKind::kOutput) outputs_[op.object].push_back(id);
  if (!op.has_result()) return;
  std::string value = expression(id, {block, schedule_.ready[id]});
  if (op.kind == OpKind::kLoad) value = expression(id, at);
  wires_ << "    wire " << range_text_spaced(op.bits) << op.name << " = " << value << ";" << where << "\n";
}

std::string ProcessEmitter::assembled() {
  emit_held_values();
  emit_copies();
  const bool takes_calls = process_.call_loop() >= 0;
  const std::string signals = handshake();
  std::string entry = go_to(0, {-1, 0}, std::string("(state == S_IDLE)") + (takes_calls ? "" : " & ap_start"),
                            "                ");
  std::ostringstream out;
  out << header() << "`default_nettype none\n\nmodule " << process_.name << " (\n";
  out << "    input wire clk,\n    input wire rst,\n    input wire ap_start,\n    input wire "
         "ap_continue,\n";
  out << "    output wire ap_done,\n    output wire ap_idle,\n    output wire ap_ready" << ports_.str()
      << "\n);\n\n";
  out << state_declarations() << registers_.str() << functions_.str() << "\n" << forward_declarations();
  out << wires_.str() << "\n" << stalls_.str() << "\n" << bodies_.str() << "\n";
  out << signals << "    always @(posedge clk) begin\n" << control_.str() << "        case (state)\n";
  out << "            S_IDLE: " << (takes_calls ? "" : "if (ap_start) ") << "begin\n"
      << entry << "            end\n"
      << cases_.str();
  if (!takes_calls) out << "            S_DONE: if (ap_continue) state <= S_IDLE;\n";
  out << "            default: state <= S_IDLE;\n        endcase\n"
      << phi_starts_.str() << "        if (rst) begin\n            state <= S_IDLE;\n"
      << loop_resets() << resets_.str();
  out << "        end\n    end\n"
      << data_block() << (has_probes_ ? probes() : "") << "\nendmodule\n\n`default_nettype wire\n";
  return out.str();
}

std::string ProcessEmitter::handshake() {
  int calls = process_.call_loop();
  if (calls < 0)
    return "    assign ap_idle = (state == S_IDLE);\n    assign ap_done = (state == S_DONE);\n"
           "    assign ap_ready = ap_done & ap_continue;\n\n";
  int last = timing(calls).length - 1;
  const std::string done = kCallDone;
  registers_ << "    reg " << done << ";\n";
  control_ << "        " << done << " <= " << happens({calls, last}) << " | (" << done
           << " & ~ap_continue);\n";
  resets_ << "            " << done << " <= 1'b0;\n";
  std::string works = last ? "(|" + block_of(calls).name + "_active[" + std::to_string(last) + ":1])" : "";
  return "    assign ap_idle = ~ap_start & ~" + done + (works.empty() ? "" : " & ~" + works) +
         ";\n    assign ap_done = " + done + ";\n    assign ap_ready = " + happens({calls, 0}) + ";\n\n";
}

std::string ProcessEmitter::state_declarations() const {
  int bits = address_bits(states_.size());
  std::ostringstream out;
  for (size_t i = 0; i < states_.size(); ++i)
    out << "    localparam [" << bits - 1 << ":0] " << states_[i] << " = " << bits << "'d" << i << ";\n";
  out << "    reg [" << bits - 1 << ":0] state;\n\n";
  return out.str();
}

std::string ProcessEmitter::loop_resets() const {
  std::string out;
  for (size_t block = 0; block < process_.blocks.size(); ++block)
    if (has_stages(block))
      out += "            " + block_of(block).name + "_active <= " + std::to_string(timing(block).length) +
             "'d0;\n";
  return out;
}

std::string ProcessEmitter::forward_declarations() {
  std::string out = "    wire stall;\n";
  for (size_t block = 0; block < process_.blocks.size(); ++block) {
    if (!is_loop(block)) continue;
    out += "    wire " + block_of(block).name + "_ce;\n";
    for (size_t group = splits(block).size(); group-- > 0;)
      out += "    wire " + group_enable(block, group) + ";\n";
  }
  return out;
}

std::string ProcessEmitter::data_block() {
  std::string body = data_.str(), resets = data_resets_.str();
  if (body.empty() && resets.empty()) return "";
  std::string out = "\n    always @(posedge clk) begin\n" + body;
  if (!resets.empty()) out += "        if (rst) begin\n" + resets + "        end\n";
  return out + "    end\n";
}

std::string ProcessEmitter::header() {
  std::ostringstream out;
  out << "// " << process_.name << ": " << process_.source_name << " of " << base_name(process_.location.file)
      << ":" << process_.location.line << ". Generated by floorline-hlsc; do not edit.\n";
  for (size_t block = 0; block < process_.blocks.size(); ++block)
    if (is_loop(block)) out << "//   loop " << describe(block) << "\n";
  out << "\n";
  return out.str();
}

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

std::string emit_process(const Process& process, const ProcessSchedule& schedule, bool has_probes) {
  return ProcessEmitter(process, schedule, has_probes).run();
}

}  // namespace hlsc
