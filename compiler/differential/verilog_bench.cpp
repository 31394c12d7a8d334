#include "differential/verilog_bench.h"

#include <fmt/format.h>

#include <algorithm>

#include "differential/native_program.h"

namespace hlsc::differential {
namespace {

/// Cycles without any transfer after which the design counts as dead.
constexpr int kIdleLimit = 200000;
/// Cycles after the last call in which nothing more may come out.
constexpr int kQuietCycles = 64;

class VerilogBench {
 public:
  VerilogBench(const CompileResult& compiled, const Steering& steering, const RecordedSizes& sizes,
               std::uint64_t seed)
      : compiled_(compiled), ports_(compiled.interface), steering_(steering), sizes_(sizes), seed_(seed) {
    const Process& first = compiled.processes[0].process;
    tells_calls_ = first.name == compiled.top.name + "_core" && first.call_loop() >= 0;
    bool has_outputs = std::any_of(ports_.scalars.begin(), ports_.scalars.end(), [&](const ScalarPort& port) {
      return port.is_output && !(port.is_result && tells_calls_);
    });
    runs_overlap_ = !ports_.has_start || (seed % 2 == 1 && ports_.memories.empty() && !has_outputs);
  }

  std::string text() {
    if (!ports_.banks.empty())
      throw CompileError(compiled_.top.location, "a case with s_axilite belongs to test/cosim");
    control();
    for (std::size_t i = 0; i < ports_.scalars.size(); ++i) scalar(i);
    for (std::size_t i = 0; i < ports_.streams.size(); ++i) stream(i);
    for (std::size_t i = 0; i < ports_.memories.size(); ++i) memory(i);
    return fmt::format(
        "`timescale 1ns / 1ps\n`default_nettype none\n\nmodule bench;\n{}\n    {} dut ({}\n    "
        ");\n\n{}\n{}\nendmodule\n",
        declarations_, ports_.module, connections_, clocked_, sequence());
  }

 private:
  void connect(const std::string& port, const std::string& signal) {
    connections_ += fmt::format("{}\n        .{}({})", connections_.empty() ? "" : ",", port, signal);
  }
  void declare(const std::string& text) { declarations_ += "    " + text + "\n"; }
  static std::string range(unsigned width) { return fmt::format("[{}:0]", width - 1); }
  int last_call() const { return steering_.calls - 1; }

  void control() {
    declare("reg clk = 0;");
    declare("always #5 clk = ~clk;");
    declare("reg reset = 1;");
    declare(fmt::format("integer seed = {};", static_cast<std::uint32_t>(seed_ * 2654435761u)));
    declare("integer cycles = 0, idle = 0, i;");
    declare("integer call = 0;      // whose scalars are on the ports");
    declare("integer available = -1;  // tokens up to this call may go in");
    declare("integer finished = 0;  // calls that are done");
    declare(
        "integer run = 0, longest = 0;  // cycles of the run from its start on, and of the longest so far");
    declare("reg moved;");
    declare(fmt::format("reg start = {0}, more = {0};  // more: calls are to be started",
                        !ports_.has_start && tells_calls_ ? 1 : 0));
    declare("reg proceed = 1;");
    declare("wire done, ready;");
    connect(ports_.clock, "clk");
    connect(ports_.reset, ports_.reset_is_low ? "~reset" : "reset");
    if (ports_.has_start) {
      connect("ap_start", "start");
      connect("ap_done", "done");
      connect("ap_ready", "ready");
      connect("ap_idle", "");
    } else {
      declare(tells_calls_ ? "assign done = dut.core.ap_done;" : "assign done = 1'b0;");
      declare(tells_calls_ ? "assign ready = dut.core.ap_ready;" : "assign ready = 1'b0;");
    }
    if (ports_.has_continue) connect("ap_continue", "proceed");
    clocked_ += fmt::format(
        "    always @(posedge clk) begin\n"
        "        cycles <= cycles + 1;\n"
        "        idle <= moved | (ready & start) | (done & proceed) ? 0 : idle + 1;\n"
        "        if (idle > {}) fail_at(\"nothing moves\");\n"
        "{}"
        "        if (done & proceed) finished <= finished + 1;\n"
        "        run <= done | ~start & run == 0 ? 0 : run + 1;\n"
        "        if (done && run > longest) longest <= run;\n"
        "{}"
        "    end\n\n",
        kIdleLimit, ports_.has_continue ? "        proceed <= ($random(seed) & 3) != 0;\n" : "", restart());
    declare("task fail_at(input [8*64-1:0] what);");
    declare("begin");
    declare("    $display(\"FAIL cycle %0d, call %0d: %0s\", cycles, finished, what);");
    declare("    $finish;");
    declare("end");
    declare("endtask");
    declare("task fail_words(input [8*64-1:0] what, input [1023:0] got, input [1023:0] wanted);");
    declare("begin");
    declare(
        "    $display(\"FAIL cycle %0d, call %0d: %0s is %0h, C++ has %0h\", cycles, finished, what, got, "
        "wanted);");
    declare("    $finish;");
    declare("end");
    declare("endtask");
  }

  std::string restart() const {
    if (!runs_overlap_) return "        if (ready & start) start <= 0;\n";
    return fmt::format(
        "        if (ready & start & call == {}) begin\n"
        "            start <= 0;\n"
        "            more <= 0;\n"
        "        end else begin\n"
        "            if (ready & start) call <= call + 1;\n"
        "            if ((ready | ~start) & more) start <= {};\n"
        "        end\n",
        last_call(), ports_.has_start ? "($random(seed) & 7) != 0" : "1");
  }

  void load(const std::string& memory) {
    loads_ += fmt::format("        $readmemh(\"{0}\", {0});\n", memory);
  }

  void words(const std::string& name, unsigned width, std::size_t count) {
    declare(fmt::format("reg {} {} [0:{}];", range(width), name, std::max<std::size_t>(count, 1) - 1));
    load(name);
  }

  void scalar(std::size_t i) {
    const ScalarPort& port = ports_.scalars[i];
    std::string recorded = fmt::format("scalar_{}_hex", i);
    words(recorded, port.width, steering_.calls);
    if (!port.is_output) {
      connect(port.name, recorded + "[call]");
      return;
    }
    std::string wire = fmt::format("scalar_{}", i), last = fmt::format("scalar_{}_last", i);
    declare(fmt::format("wire {} {};", range(port.width), wire));
    declare(fmt::format("reg {} {};", range(port.width), last));
    connect(port.name, wire);
    std::string taken = "done";
    if (port.is_result && runs_overlap_ && tells_calls_) {
      clocked_ += fmt::format(
          "    always @(posedge clk) if (done & proceed && finished < {0} && ({1} & {2}'h{3}) !== "
          "({4}[finished] "
          "& {2}'h{3}))\n        fail_words(\"{5}\", {1}, {4}[finished]);\n",
          steering_.calls, wire, port.width, value_mask(compiled_, port), recorded, port.name);
      return;
    }
    if (port.has_valid()) {
      taken = wire + "_valid";
      declare(fmt::format("wire {};", taken));
      connect(port.name + "_ap_vld", taken);
      words(fmt::format("scalar_{}_before", i), port.width, steering_.calls);
      prepare_ += fmt::format("            {} = scalar_{}_before[call];\n", last, i);
    }
    clocked_ += fmt::format("    always @(posedge clk) if ({}) {} <= {};\n", taken, last, wire);
    check_ += fmt::format(
        "            if (({0} & {1}'h{2}) !== ({3}[call] & {1}'h{2})) fail_words(\"{4}\", {0}, {3}[call]);\n",
        last, port.width, value_mask(compiled_, port), recorded, port.name);
  }

  /// A register `NAME_pause` that is 1 in random cycles; quiet and busy phases alternate.
  void pauses(const std::string& name) {
    declare(fmt::format("reg {}_pause = 0;", name));
    if (seed_ == 0) return;
    declare(fmt::format("integer {0}_rate = 0, {0}_phase = 0;", name));
    clocked_ += fmt::format(
        "    always @(posedge clk) begin\n"
        "        {0}_phase <= {0}_phase == 0 ? $random(seed) & 63 : {0}_phase - 1;\n"
        "        if ({0}_phase == 0) {0}_rate <= ($random(seed) & 3) * 80;\n"
        "        {0}_pause <= ($random(seed) & 255) < {0}_rate;\n"
        "    end\n",
        name);
  }

  void stream(std::size_t i) {
    const InterfaceStream& stream = ports_.streams[i];
    std::string name = fmt::format("stream_{}", i);
    words(name + "_hex", stream.width, sizes_.streams[i]);
    words(name + "_end", 32, steering_.calls);
    declare(fmt::format("integer {0}_next = 0, {0}_following;", name));
    pauses(name);
    if (stream.is_input)
      input_stream(stream, name);
    else
      output_stream(stream, name);
    moves_ += fmt::format(" | {0}_valid & {0}_ready", name);
  }

  void connect_stream(const InterfaceStream& stream, const std::string& name) {
    connect(stream.valid, name + "_valid");
    connect(stream.ready, name + "_ready");
    for (const InterfaceField& field : stream.fields)
      connect(field.signal, stream.fields.size() == 1 ? name + "_data"
                                                      : fmt::format("{}_data[{}:{}]", name,
                                                                    field.low + field.width - 1, field.low));
  }

  void input_stream(const InterfaceStream& stream, const std::string& name) {
    declare(fmt::format("reg {}_valid = 0;", name));
    declare(fmt::format("wire {}_ready;", name));
    declare(fmt::format("wire {0} {1}_data = {1}_valid ? {1}_hex[{1}_next] : {2}'bx;", range(stream.width),
                        name, stream.width));
    connect_stream(stream, name);
    clocked_ += fmt::format(
        "    always @(posedge clk) begin\n"
        "        {0}_following = {0}_next + ({0}_valid & {0}_ready);\n"
        "        {0}_next <= {0}_following;\n"
        "        if (~{0}_valid | {0}_ready)\n"
        "            {0}_valid <= available >= 0 && {0}_following < {0}_end[available] && !{0}_pause;\n"
        "    end\n",
        name);
  }

  void output_stream(const InterfaceStream& stream, const std::string& name) {
    declare(fmt::format("wire {0}_valid;", name));
    declare(fmt::format("wire {0}_ready = ~{0}_pause;", name));
    declare(fmt::format("wire {} {}_data;", range(stream.width), name));
    connect_stream(stream, name);
    clocked_ += fmt::format(
        "    always @(posedge clk) if ({0}_valid & {0}_ready & ~reset) begin\n"
        "        if ({0}_next >= {0}_end[{1}]) fail_at(\"too many tokens in {2}\");\n"
        "        else if ({0}_data !== {0}_hex[{0}_next]) fail_words(\"{2}\", {0}_data, {0}_hex[{0}_next]);\n"
        "        {0}_next <= {0}_next + 1;\n"
        "    end\n",
        name, last_call(), stream.name);
    waits_ += fmt::format(" || {0}_next < {0}_end[LIMIT]", name);
    if (runs_overlap_) return;
    check_ += fmt::format("            if ({0}_next > {0}_end[call]) fail_at(\"too many tokens in {1}\");\n",
                          name, stream.name);
  }

  void memory(std::size_t i) {
    const InterfaceMemory& memory = ports_.memories[i];
    std::string name = fmt::format("memory_{}", i);
    long count = element_count(compiled_, steering_, memory.argument);
    std::string type = range(memory.width);
    words(name + "_before", memory.width, count * steering_.calls);
    words(name + "_after", memory.width, count * steering_.calls);
    declare(fmt::format("reg {} {} [0:{}];", type, name, count - 1));
    prepare_ += fmt::format(
        "            for (i = 0; i < {1}; i = i + 1) {0}[i] = {0}_before[call * {1} + i];\n", name, count);
    check_ += fmt::format(
        "            for (i = 0; i < {1}; i = i + 1)\n"
        "                if ({0}[i] !== {0}_after[call * {1} + i]) begin\n"
        "                    $display(\"element %0d:\", i);\n"
        "                    fail_words(\"{2}\", {0}[i], {0}_after[call * {1} + i]);\n"
        "                end\n",
        name, count, memory.name);
    for (std::size_t k = 0; k < memory.ports.size(); ++k)
      memory_port(memory, memory.ports[k], name, fmt::format("{}_{}", name, k), count);
  }

  void memory_port(const InterfaceMemory& memory, const InterfaceMemoryPort& port, const std::string& words,
                   const std::string& name, long count) {
    declare(fmt::format("wire {}_ce;", name));
    declare(fmt::format("wire [31:0] {}_at;", name));
    declare(fmt::format("assign {}_at[31:{}] = 0;", name, address_bits(memory.depth)));
    connect(port.address, name + "_at" + address_range(memory));
    connect(port.enable, name + "_ce");
    moves_ += fmt::format(" | {}_ce", name);
    if (!port.read_data.empty()) {
      declare(fmt::format("reg {} {}_q;", range(memory.width), name));
      connect(port.read_data, name + "_q");
      clocked_ +=
          fmt::format("    always @(posedge clk) if ({0}_ce) {0}_q <= {0}_at < {1} ? {3}[{0}_at] : {2}'bx;\n",
                      name, count, memory.width, words);
    }
    if (port.write_enable.empty()) return;
    declare(fmt::format("wire {}_we;", name));
    declare(fmt::format("wire {} {}_d;", range(memory.width), name));
    connect(port.write_enable, name + "_we");
    connect(port.write_data, name + "_d");
    clocked_ += fmt::format(
        "    always @(posedge clk)\n"
        "        if ({0}_ce && {0}_we) begin\n"
        "            if ({0}_at < {1}) {3}[{0}_at] <= {0}_d;\n"
        "            else fail_at(\"write beyond the end of {2}\");\n"
        "        end\n",
        name, count, memory.name, words);
  }

  static std::string address_range(const InterfaceMemory& memory) {
    return fmt::format("[{}:0]", address_bits(memory.depth) - 1);
  }

  std::string waiting(const std::string& limit) const {
    std::string text = waits_;
    for (std::size_t at; (at = text.find("LIMIT")) != std::string::npos;) text.replace(at, 5, limit);
    return text;
  }

  std::string sequence() const {
    std::string moved = fmt::format("    always @* moved = 1'b0{};\n", moves_);
    std::string body = runs_overlap_ ? overlapping_calls() : separate_calls();
    return moved + "    initial begin\n" + loads_ +
           "        repeat (4) @(posedge clk);\n        reset <= 0;\n" +
           fmt::format("        repeat ({}) @(posedge clk);\n", 1 + seed_ % 3) + body +
           fmt::format(
               "        repeat ({}) @(posedge clk);\n"
               "        $display(\"PASS in %0d cycles, longest run %0d\", cycles, longest);\n"
               "        $finish;\n"
               "    end\n",
               kQuietCycles);
  }

  std::string overlapping_calls() const {
    std::string start = ports_.has_start ? "        more <= 1;\n" : "";
    std::string done = ports_.has_start ? fmt::format("finished < {}", steering_.calls) : "0";
    return fmt::format("        available <= {};\n{}        while ({}{}) @(posedge clk);\n", last_call(),
                       start, done, waiting(std::to_string(last_call())));
  }

  std::string separate_calls() const {
    return fmt::format(
               "        for (call = 0; call < {}; call = call + 1) begin\n{}"
               "            start <= 1;\n"
               "            available <= call;\n"
               "            while (finished <= call{}) @(posedge clk);\n"
               "            repeat (2) @(posedge clk);\n",
               steering_.calls, prepare_, waiting("call")) +
           check_ + fmt::format("        end\n        call = {};\n", last_call());
  }

  const CompileResult& compiled_;
  const TopInterface& ports_;
  const Steering& steering_;
  const RecordedSizes& sizes_;
  std::uint64_t seed_;
  bool runs_overlap_ = false;
  bool tells_calls_ = false;  ///< The calls of the only process overlap, and it tells of each.
  std::string declarations_, connections_, clocked_, loads_, prepare_, check_, moves_, waits_;
};

}  // namespace

std::string verilog_bench(const CompileResult& compiled, const Steering& steering, const RecordedSizes& sizes,
                          std::uint64_t seed) {
  return VerilogBench(compiled, steering, sizes, seed).text();
}

}  // namespace hlsc::differential
