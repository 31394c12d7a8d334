#include "verilog/emit_probes.h"

#include "verilog/process_emitter.h"

namespace hlsc {

namespace {

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

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
    if (is_loop(block)) out << loop_probe(block);
  return out.str();
}

std::string ProcessEmitter::loop_probe(int block) {
  const Block& loop = block_of(block);
  std::string stem = names_.unique("probe_" + loop.name), goes_on = stem + "_goes_on", last = stem + "_last",
              intervals = stem + "_intervals", cycles = stem + "_cycles";
  std::ostringstream out;
  out << "    reg " << goes_on << " = 0;\n    longint " << last << " = 0, " << intervals << " = 0, " << cycles
      << " = 0;\n    always @(posedge clk) begin\n        if (rst || state != " << state_name(block, 0)
      << ") " << goes_on << " <= 1'b0;\n        else if (" << happens({block, 0}) << ") begin\n            "
      << goes_on << " <= 1'b1;\n            " << last << " <= probe_clock;\n            if (" << goes_on
      << ") begin\n                " << intervals << " <= " << intervals << " + 1;\n                "
      << cycles << " <= " << cycles << " + probe_clock - " << last
      << ";\n            end\n        end\n    end\n    final if (" << intervals
      << " != 0) hlsc_loop($sformatf(\"%m\"), " << quoted(loop.name) << ", " << quoted(loop.location.text())
      << ", " << timing(block).ii << ", " << intervals << ", " << cycles << ");\n";
  return out.str();
}

}  // namespace hlsc
