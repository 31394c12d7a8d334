#include "verilog/emit_probes.h"

#include <algorithm>

#include "verilog/process_emitter.h"

namespace hlsc {

namespace {

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

std::string access_text(const Operation& op) {
  return (op.kind == OpKind::kLoad ? "the read at " : "the write at ") + op.location.text();
}

}  // namespace

std::string probe_imports() {
  return R"(
    // Told to the co-simulation (cosim/probes.h).
    import "DPI-C" function int hlsc_asked();
    import "DPI-C" function void hlsc_waits(input string who, input string what, input string place,
                                            input int kind);
    import "DPI-C" function void hlsc_end(input string who, input string port, input string stream,
                                          input int is_reader);
    import "DPI-C" function void hlsc_fifo(input string name, input int depth, input int held,
                                           input int most);
    import "DPI-C" function void hlsc_loop(input string who, input string name, input string place,
                                           input int ii, input longint intervals, input longint cycles);
    import "DPI-C" function void hlsc_dependence(input string who, input string name, input string early,
                                                 input string late, input int distance);
)";
}

std::string fifo_probe(const std::string& name, int depth) {
  std::string held = name + "_probe_held", most = name + "_probe_most";
  std::string told =
      "hlsc_fifo(" + quoted(name) + ", " + std::to_string(depth) + ", " + held + ", " + most + ");\n";
  return "    int " + held + " = 0, " + most + " = 0;\n    always @(posedge ap_clk) begin\n        " + held +
         " <= " + held + " + 32'(" + name + "_write & " + name + "_full_n) - 32'(" + name + "_read & " +
         name + "_empty_n);\n        if (" + held + " > " + most + ") " + most + " <= " + held +
         ";\n        if (rst) begin\n            " + held + " <= 0;\n            " + most +
         " <= 0;\n        end\n        if (hlsc_asked() != 0) " + told + "    end\n    final " + told;
}

std::string run_probe(const std::string& done) {
  return "    import \"DPI-C\" function void hlsc_run_ends();\n    always @(posedge ap_clk) if (" + done +
         ") hlsc_run_ends();\n";
}

std::string end_probe(const std::string& instance, const std::string& port, const std::string& stream,
                      bool is_reader) {
  return "    always @(posedge ap_clk) if (hlsc_asked() != 0) hlsc_end(" + quoted(instance) + ", " +
         quoted(port) + ", " + quoted(stream) + ", " + (is_reader ? "1" : "0") + ");\n";
}

std::string gate_probe(const std::string& instance, const std::string& channel, bool is_reader) {
  return "    always @(posedge ap_clk) if (hlsc_asked() != 0 && " + instance + "_start & ~" + channel +
         (is_reader ? "_ready" : "_free") + ") hlsc_waits(" + quoted(instance) + ", " + quoted(channel) +
         ", \"\", " + (is_reader ? "3" : "2") + ");\n";
}

std::string ProcessEmitter::probes() {
  std::ostringstream out;
  out << probe_imports()
      << "    longint probe_clock = 0;\n    always @(posedge clk) probe_clock <= probe_clock + 1;\n";
  for (const auto& [id, condition] : blocked_) {
    const Operation& op = process_[id];
    out << "    always @(posedge clk) if (hlsc_asked() != 0 && " << condition
        << ") hlsc_waits($sformatf(\"%m\"), " << quoted(process_.streams[op.object].name) << ", "
        << quoted(op.location.text()) << ", " << (op.kind == OpKind::kRead ? 1 : 0) << ");\n";
  }
  for (size_t block = 0; block < process_.blocks.size(); ++block)
    if (is_loop(block)) {
      out << loop_probe(block);
      for (size_t memory = 0; memory < process_.memories.size(); ++memory)
        if (llvm::any_of(process_.memories[memory].claims,
                         [&](const DependenceClaim& claim) { return block_of(block).has(claim); }))
          out << dependence_probe(block, memory);
    }
  return out.str();
}

std::string ProcessEmitter::loop_probe(int block) {
  const Block& loop = block_of(block);
  std::string stem = names_.unique("probe_" + loop.name), goes_on = stem + "_goes_on", last = stem + "_last",
              intervals = stem + "_intervals", cycles = stem + "_cycles";
  std::string pauses = "state != " + state_name(block, 0);
  if (loop.takes_calls) {  // Nobody calls, or what the call reads is not there.
    pauses += " || " + active({block, 0}) + " & ~ap_start";
    for (const auto& [id, condition] : blocked_)
      if (process_[id].kind == OpKind::kRead && process_[id].block == block && schedule_.start[id] == 0)
        pauses += " || " + condition;
  }
  auto source = std::ranges::find(process_.loops, block, &SourceLoop::header);
  const std::string& name = source == process_.loops.end() ? loop.name : source->name;
  std::ostringstream out;
  out << "    reg " << goes_on << " = 0;\n    longint " << last << " = 0, " << intervals << " = 0, " << cycles
      << " = 0;\n    always @(posedge clk) begin\n        if (rst || " << pauses << ") " << goes_on
      << " <= 1'b0;\n        else if (" << happens({block, 0}) << ") begin\n            " << goes_on
      << " <= 1'b1;\n            " << last << " <= probe_clock;\n            if (" << goes_on
      << ") begin\n                " << intervals << " <= " << intervals << " + 1;\n                "
      << cycles << " <= " << cycles << " + probe_clock - " << last
      << ";\n            end\n        end\n    end\n    final if (" << intervals
      << " != 0) hlsc_loop($sformatf(\"%m\"), " << quoted(name) << ", " << quoted(loop.location.text())
      << ", " << timing(block).ii << ", " << intervals << ", " << cycles << ");\n";
  return out.str();
}

/// Every access counts its iterations and notes for each word the last one in which it was there. An access
/// that comes to a word which one of a later iteration, or one that follows in its own, has had before it is
/// out of order. Iterations behind the last one are taken back, so it is told when the loop has ended.
std::string ProcessEmitter::dependence_probe(int block, int memory) {
  const std::vector<ValueId>& order = block_of(block).operations;
  auto place_of = [&](ValueId id) { return std::find(order.begin(), order.end(), id) - order.begin(); };
  std::vector<ValueId> users;
  for (ValueId id : accesses_[memory])
    if (process_[id].block == block) users.push_back(id);
  std::sort(users.begin(), users.end(),
            [&](ValueId a, ValueId b) { return schedule_.start[a] < schedule_.start[b]; });
  const Memory& array = process_.memories[memory];
  const std::string stem = names_.unique("probe_" + block_of(block).name + "_" + array.name);
  const std::string words = " [0:" + std::to_string((uint64_t{1} << address_bits(array.depth)) - 1) + "];\n";
  std::ostringstream declared, cleared, noted, told;
  declared << "    int " << stem << "_ended = 0;\n    reg " << stem << "_runs = 1;\n";
  std::string ended = happens({block, timing(block).length - 1});
  for (size_t y = 0; y < users.size(); ++y) {
    const Operation& late = process_[users[y]];
    Place at{block, schedule_.start[users[y]]};
    std::string name = stem + "_" + std::to_string(y), here = happens(at), taken = happens(late, at);
    std::string address = text(late.operands[0], address_bits(array.depth), at);
    declared << "    int " << name << "_count = 0, " << name << "_last" << words;
    cleared << "            " << name << "_count = 0;\n            for (int i = 0; i < " << array.depth
            << "; i++) " << name << "_last[i] = -1;\n";
    noted << "            if (" << taken << ") " << name << "_last[" << address << "] = " << name
          << "_count;\n";
    for (size_t x = 0; x < y; ++x) {
      const Operation& early = process_[users[x]];
      if (early.kind == OpKind::kLoad && late.kind == OpKind::kLoad) continue;
      std::string other = stem + "_" + std::to_string(x) + "_last[" + address + "]",
                  pair = name + "_" + std::to_string(x);
      bool precedes =
          place_of(users[x]) > place_of(users[y]) && schedule_.start[users[x]] < schedule_.start[users[y]];
      declared << "    int " << pair << "_distance = -1, " << pair << "_iteration = 0;\n";
      cleared << "            if (" << pair << "_distance >= 0 && " << pair << "_iteration < " << stem
              << "_ended)\n                hlsc_dependence($sformatf(\"%m\"), " << quoted(array.name) << ", "
              << quoted(access_text(early)) << ", " << quoted(access_text(late)) << ", " << pair
              << "_distance);\n            " << pair << "_distance = -1;\n";
      told << "            if (" << taken << " && " << other << (precedes ? " >= " : " > ") << name
           << "_count && " << pair << "_distance < 0) begin\n                " << pair
           << "_distance = " << other << " - " << name << "_count;\n                " << pair
           << "_iteration = " << other << ";\n            end\n";
    }
    told << "            if (" << here << ") " << name << "_count = " << name << "_count + 1;\n";
  }
  std::ostringstream out;
  out << declared.str() << "    always @(posedge clk)\n        if (rst || state != " << state_name(block, 0)
      << ") begin if (" << stem << "_runs) begin\n"
      << cleared.str() << "            " << stem << "_ended = 0;\n            " << stem
      << "_runs = 0;\n        end end else begin\n            " << stem << "_runs = 1;\n"
      << noted.str() << told.str() << "            if (" << ended << ") " << stem << "_ended = " << stem
      << "_ended + 1;\n        end\n";
  return out.str();
}

}  // namespace hlsc
