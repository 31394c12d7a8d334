#include "verilog/process_emitter.h"
#include "verilog/text.h"

namespace hlsc {

void ProcessEmitter::emit_streams() {
  Stalls stalls;
  for (size_t index = 0; index < process_.streams.size(); ++index) emit_stream(index, stalls);
  stalls_ << "    assign stall = " << (stalls.plain.empty() ? "1'b0" : stalls.plain) << ";\n";
  for (size_t block = 0; block < process_.blocks.size(); ++block)
    if (is_loop(block)) emit_enables(block, stalls.groups[block]);
}

/// A group stops when an access in it is blocked, and when those behind stop.
void ProcessEmitter::emit_enables(int block, std::map<size_t, std::string>& blocked) {
  auto add = [&](size_t group, const std::string& condition) {
    blocked[group] += (blocked[group].empty() ? "" : " | ") + ("(" + condition + ")");
  };
  const size_t last = splits(block).size();
  if (block_of(block).takes_calls) {
    add(0, active({block, 0}) + " & ~ap_start");
    add(last, active({block, timing(block).length - 1}) + " & " + kCallDone + " & ~ap_continue");
    for (size_t group = 0; group < last; ++group)
      if (!works_behind(block, group).empty()) add(group, "|" + group_slip(block, group));
  }
  stalls_ << "    assign " << group_enable(block, last) << " = "
          << (blocked[last].empty() ? "1'b1" : "~(" + blocked[last] + ")") << ";\n";
  for (size_t group = last; group-- > 0;)
    stalls_ << "    assign " << group_enable(block, group) << " = " << group_enable(block, group + 1)
            << " & ~(" << blocked[group] << ");\n";
}

void ProcessEmitter::emit_stream(int index, Stalls& stalls) {
  const Stream& stream = process_.streams[index];
  std::string strobe, data;
  const std::vector<ValueId> users = in_order_of_choice(stream_accesses_[index]);
  for (size_t i = 0; i < users.size(); ++i) {
    const Operation& op = process_[users[i]];
    Place at{op.block, schedule_.start[users[i]]};
    std::string wish = active(at) + (op.predicate == kNoValue ? "" : " & " + bit(op.predicate, at));
    std::string blocked = wish + " & ~" + stream.name + (stream.is_input ? "_empty_n" : "_full_n");
    blocked_[users[i]] = blocked;
    std::string& sum = is_loop(op.block) ? stalls.groups[op.block][group_of(at)] : stalls.plain;
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
      // The result of a call stays until it is done.
      if (port.is_result && block_of(op.block).takes_calls) at.cycle = timing(op.block).length - 1;
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
