#include "verilog/process_emitter.h"
#include "verilog/text.h"

namespace hlsc {

void ProcessEmitter::emit_streams() {
  Stalls stalls;
  for (size_t index = 0; index < process_.streams.size(); ++index) emit_stream(index, stalls);
  stalls_ << "    assign stall = " << (stalls.plain.empty() ? "1'b0" : stalls.plain) << ";\n";
  for (size_t block = 0; block < process_.blocks.size(); ++block) {
    if (!is_loop(block)) continue;
    const std::string &name = block_of(block).name, &back = stalls.back[block];
    stalls_ << "    assign " << name << "_ce = " << (back.empty() ? "1'b1" : "~(" + back + ")") << ";\n";
    if (split_stage(block) >= 0)
      stalls_ << "    assign " << name << "_front_ce = " << name << "_ce & ~(" << stalls.front[block]
              << ");\n";
  }
}

void ProcessEmitter::emit_stream(int index, Stalls& stalls) {
  const Stream& stream = process_.streams[index];
  std::string strobe, data;
  const std::vector<ValueId>& users = stream_accesses_[index];
  for (size_t i = 0; i < users.size(); ++i) {
    const Operation& op = process_[users[i]];
    Place at{op.block, schedule_.start[users[i]]};
    std::string wish = active(at) + (op.predicate == kNoValue ? "" : " & " + bit(op.predicate, at));
    std::string blocked = wish + " & ~" + stream.name + (stream.is_input ? "_empty_n" : "_full_n");
    blocked_[users[i]] = blocked;
    std::string& sum = !is_loop(op.block)                  ? stalls.plain
                       : at.cycle <= split_stage(op.block) ? stalls.front[op.block]
                                                           : stalls.back[op.block];
    sum += (sum.empty() ? "" : " | ") + ("(" + blocked + ")");
    strobe += (i ? " | " : "") + ("(" + happens(op, at) + ")");
    if (stream.is_input) continue;
    bool is_last = i + 1 == users.size();
    data += (is_last ? "" : "(" + wish + ") ? ") + text(op.operands[0], stream.width, at) +
            (is_last ? "" : " : ");
  }
  emit_stream_port(stream, strobe.empty() ? "1'b0" : strobe,
                   data.empty() ? std::to_string(stream.width) + "'d0" : data);
}

void ProcessEmitter::emit_stream_port(const Stream& stream, const std::string& strobe,
                                      const std::string& data) {
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

void ProcessEmitter::emit_outputs() {
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

}  // namespace hlsc
