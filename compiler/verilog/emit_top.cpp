#include "verilog/emit_top.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "verilog/axilite.h"
#include "verilog/emit_probes.h"
#include "verilog/emit_process.h"
#include "verilog/text.h"

namespace hlsc {

namespace {

const std::set<std::string> kModes = {"axis",         "ap_fifo",    "ap_none",      "ap_vld",
                                      "ap_memory",    "bram",       "s_axilite",    "ap_stable",
                                      "ap_ctrl_none", "ap_ctrl_hs", "ap_ctrl_chain"};

/// `mode=NAME` or the bare NAME; empty without one.
std::string mode_of(const Directive& directive) {
  static const std::set<std::string> kFlags = {"register", "both", "forward", "reverse", "off"};
  std::string mode = directive.text("mode");
  for (const auto& [key, value] : directive.options)
    if (mode.empty() && value.empty() && !kFlags.count(key)) mode = key;
  return mode;
}

/// Refuses modes that do not exist or that no port is built for.
void check_mode(const std::string& mode, const SourceLocation& where) {
  static const std::map<std::string, std::string> kNotBuilt = {{"ap_hs", "hls::stream with ap_fifo or axis"},
                                                               {"ap_ack", "hls::stream with ap_fifo or axis"},
                                                               {"ap_ovld", "ap_vld"},
                                                               {"ap_bus", "an array with ap_memory"}};
  if (auto refused = kNotBuilt.find(mode); refused != kNotBuilt.end())
    throw CompileError(where, "INTERFACE mode '" + mode + "' is not built; use " + refused->second);
  if (mode.empty() || kModes.count(mode)) return;
  std::string known;
  for (const std::string& name : kModes) known += (known.empty() ? "" : ", ") + name;
  throw CompileError(where, "INTERFACE mode '" + mode + "' does not exist; use one of " + known);
}

}  // namespace

PortModes PortModes::from(const std::vector<PortDirective>& directives, Diagnostics& diagnostics) {
  PortModes modes;
  std::set<std::string> masters;
  for (const PortDirective& entry : directives)
    if (mode_of(entry.directive) == "m_axi") {
      masters.insert(entry.port);
      diagnostics.warn(entry.location, "INTERFACE mode 'm_axi' is not built: '" + entry.port +
                                           "' has the ports of ap_memory in place of a bus master");
    }
  for (const PortDirective& entry : directives) {
    if (masters.count(entry.port)) continue;  // Its s_axilite is the offset on the bus.
    std::string mode = mode_of(entry.directive);
    check_mode(mode, entry.location);
    std::map<std::string, std::string>& merged =
        modes.by_port[entry.port.empty() ? "return" : entry.port].options;
    for (const auto& [key, value] : entry.directive.options)
      if (key != "mode" && key != "bundle") merged[key] = value;
    if (mode == "s_axilite")
      merged["bank"] = entry.directive.has("bundle") ? entry.directive.text("bundle") : "control";
    else if (!mode.empty())
      merged["mode"] = mode;
  }
  return modes;
}

std::string PortModes::mode(const std::string& port) const {
  auto found = by_port.find(port);
  return found == by_port.end() ? "" : found->second.text("mode");
}

std::string PortModes::bank(const std::string& port) const {
  auto found = by_port.find(port);
  return found == by_port.end() ? "" : found->second.text("bank");
}

namespace {

/// Scalars of a run from this many bits on lie in LUT RAM.
constexpr unsigned kWideScalars = 8;

/// When the instances of a region take this many bits in all, each has one register for those of its run: a
/// LUT RAM before each would cost more than it is worth to have more than two runs under way.
constexpr unsigned kRegisteredScalars = 256;

/// Runs under way in a region where runs of an instance overlap.
constexpr int kOverlappingRuns = 32;

class TopWriter {
 public:
  TopWriter(const FunctionInfo& top, const PortModes& modes, bool has_probes)
      : top_(top), modes_(modes), has_probes_(has_probes) {
    interface_.module = top.name;
    interface_.clock = "ap_clk";
    std::string control = modes.mode("return");
    interface_.has_start = control != "ap_ctrl_none";
    interface_.has_continue = control == "ap_ctrl_chain";
    for (const Parameter& parameter : top.parameters)
      if (!parameter.streams.empty() && modes.mode(parameter.name) == "axis") interface_.reset_is_low = true;
    for (const auto& [port, directive] : modes.by_port)
      if (directive.has("bank")) interface_.reset_is_low = true;
    interface_.reset = interface_.reset_is_low ? "ap_rst_n" : "ap_rst";
    port("input", 1, interface_.clock);
    port("input", 1, interface_.reset);
    std::string bank = interface_.has_start ? modes.bank("return") : "";
    if (!bank.empty()) {
      bank_named(bank).has_control = true;
      bank_named(bank).has_continue = interface_.has_continue;
    }
    if (interface_.has_start)
      for (const char* name : {"ap_start", "ap_done", "ap_idle", "ap_ready"})
        port_or_wire(bank, std::string(name) == "ap_start" ? "input" : "output", 1, name);
    if (interface_.has_continue) port_or_wire(bank, "input", 1, "ap_continue");
    body_ << "    wire rst = " << (interface_.reset_is_low ? "~" : "") << interface_.reset << ";\n";
  }

  TopModule single(const Process& process) {
    for (const Stream& stream : process.streams) add_stream(stream, stream.is_input);
    for (const ScalarPort& scalar : process.scalars) add_scalar(scalar);
    add_memories(process, {});
    if (!interface_.has_start) body_ << "    wire ap_start = 1'b1;\n";
    if (!interface_.has_continue) body_ << "    wire ap_continue = 1'b1;\n";
    bool tells = has_probes_ && !interface_.has_start && process.streams.empty();
    if (tells) body_ << "    wire core_done;\n" << run_probe("core_done");
    interface_.tells_runs = tells;
    body_ << "\n    " << process.name
          << " core (\n        .clk(ap_clk),\n        .rst(rst),\n        .ap_start(ap_start),\n        "
             ".ap_continue(ap_continue),\n";
    body_ << (interface_.has_start
                  ? "        .ap_done(ap_done),\n        .ap_idle(ap_idle),\n        .ap_ready(ap_ready)"
                  : "        .ap_done(" + std::string(tells ? "core_done" : "") +
                        "),\n        .ap_idle(),\n        .ap_ready()");
    for (const std::string& name : ports_of(process)) body_ << ",\n        ." << name << "(" << name << ")";
    body_ << "\n    );\n";
    return finished();
  }

  TopModule dataflow(const Region& region, const std::vector<const Process*>& processes,
                     const std::vector<std::string>& taps) {
    processes_ = processes;
    runs_overlap_ = std::any_of(processes.begin(), processes.end(),
                                [](const Process* process) { return process->call_loop() >= 0; });
    if (has_probes_) body_ << probe_imports();
    for (const RegionStream& stream : region.streams) {
      if (stream.argument >= 0)
        add_stream(stream, stream.writer < 0);
      else if (stream.channel < 0)
        add_fifo(stream);
    }
    for (const std::string& tap : taps) add_tap(stream_between(region, tap));
    for (const RegionChannel& channel : region.channels)
      if (channel.reader >= 0) add_channel(channel);
    for (const RegionStream& stream : region.streams)
      if (stream.channel >= 0) add_tokens(stream, region.channels[stream.channel].name);
    for (const RegionScalar& scalar : region.scalars) declare_region_scalar(scalar);
    for (const ScalarPort& scalar : region.head.scalars)
      if (scalar.instance < 0) add_scalar(scalar);
    if (!runs_freely(region)) add_head(region);
    size_t count = std::count_if(region.instances.begin(), region.instances.end(),
                                 [&](const Instance& instance) { return !runs_freely(instance, region); });
    has_registers_ = !region.is_loop && bits_taken(region, processes) >= kRegisteredScalars;
    if (has_registers_)
      body_ << "    wire run_waits;\n    reg" << range_text(count)
            << " taken;  // instances that have the scalars of the next run\n";
    for (size_t i = 0; i < region.instances.size(); ++i)
      add_instance(region, i, *processes[region.instances[i].process]);
    for (const RegionScalar& scalar : region.scalars) add_region_scalar(region, scalar);
    if (!runs_freely(region)) add_run_control(region.is_loop);
    return finished();
  }

 private:
  void port(const std::string& direction, unsigned width, const std::string& name) {
    ports_ << (ports_.str().empty() ? "" : ",\n") << "    " << direction << " wire" << range_text(width)
           << " " << name;
  }

  /// A signal that leads outside, or to the bank of this name.
  void port_or_wire(const std::string& bank, const std::string& direction, unsigned width,
                    const std::string& name) {
    if (bank.empty())
      port(direction, width, name);
    else
      wires_ << "    wire" << range_text(width) << " " << name << ";\n";
  }

  AxiliteBank& bank_named(const std::string& name) {
    for (AxiliteBank& bank : interface_.banks)
      if (bank.name == name) return bank;
    interface_.banks.emplace_back().name = name;
    return interface_.banks.back();
  }

  // --- Streams ---

  /// Inside, a stream has FIFO signals (NAME_dout, NAME_empty_n, NAME_read or NAME_din, NAME_full_n,
  /// NAME_write).
  template <class AnyStream>
  void add_stream(const AnyStream& from, bool is_input) {
    InterfaceStream stream;
    stream.name = from.name;
    stream.width = from.width;
    stream.is_input = is_input;
    stream.argument = from.argument;
    stream.index = from.index;
    if (modes_.mode(top_.parameters[from.argument].name) == "axis")
      add_axis(stream);
    else
      add_fifo_port(stream);
    interface_.streams.push_back(stream);
  }

  void add_fifo_port(InterfaceStream& stream) {
    const std::string& name = stream.name;
    stream.valid = name + (stream.is_input ? "_empty_n" : "_write");
    stream.ready = name + (stream.is_input ? "_read" : "_full_n");
    stream.fields = {{name + (stream.is_input ? "_dout" : "_din"), 0, stream.width}};
    port(stream.is_input ? "input" : "output", stream.width, stream.fields[0].signal);
    port("input", 1, name + (stream.is_input ? "_empty_n" : "_full_n"));
    port("output", 1, name + (stream.is_input ? "_read" : "_write"));
  }

  /// TDATA carries the element in whole bytes; the fields of an ap_axiu have signals of their own.
  void add_axis(InterfaceStream& stream) {
    const std::string& name = stream.name;
    const std::string from = stream.is_input ? "input" : "output", to = stream.is_input ? "output" : "input";
    stream.valid = name + "_TVALID";
    stream.ready = name + "_TREADY";
    const TypeLayout& layout = top_.parameters[stream.argument].layout;
    bool has_side_channels = layout.type_name.find("ap_axi") != std::string::npos ||
                             layout.type_name.find("hls::axis") != std::string::npos;
    unsigned low = 0;
    for (const Leaf& leaf : layout.leaves) {
      std::string signal = leaf.name;
      std::transform(signal.begin(), signal.end(), signal.begin(), ::toupper);
      if (has_side_channels)
        stream.fields.push_back({name + "_T" + signal.substr(0, signal.find('.')), low, leaf.width});
      low += leaf.width;
    }
    unsigned padded = (stream.width + 7) / 8 * 8;
    if (!has_side_channels) stream.fields = {{name + "_TDATA", 0, stream.width}};
    std::string inner = stream.is_input ? name + "_dout" : name + "_axis_data";
    body_ << "\n    // " << name << ": AXI4-Stream\n    wire" << range_text(stream.width) << " " << inner
          << ";\n";
    for (const InterfaceField& field : stream.fields) {
      port(from, has_side_channels ? field.width : padded, field.signal);
      std::string part = field.width == stream.width
                             ? inner
                             : inner + "[" + std::to_string(field.low + field.width - 1) + ":" +
                                   std::to_string(field.low) + "]";
      std::string outer =
          has_side_channels ? field.signal : resized_text(field.signal, padded, false, stream.width);
      if (stream.is_input)
        body_ << "    assign " << part << " = " << outer << ";\n";
      else
        body_ << "    assign " << field.signal << " = "
              << (has_side_channels ? part : resized_text(inner, stream.width, false, padded)) << ";\n";
    }
    port(from, 1, stream.valid);
    port(to, 1, stream.ready);
    if (stream.is_input) {
      body_ << "    wire " << name << "_empty_n = " << stream.valid << ";\n    wire " << name
            << "_read;\n    assign " << stream.ready << " = " << name << "_read;\n";
    } else {
      body_ << "    wire" << range_text(stream.width) << " " << name << "_din;\n    wire " << name
            << "_full_n, " << name << "_write;\n";
      fifo(name + "_register", stream.width, port_depth(top_.parameters[stream.argument].name),
           {name + "_din", name + "_write", name + "_full_n"}, {inner, stream.valid, stream.ready});
    }
  }

  /// register_mode=forward: TDATA and TVALID come from registers, TREADY goes straight through where the
  /// target has such FIFOs.
  int port_depth(const std::string& parameter) const {
    auto found = modes_.by_port.find(parameter);
    bool is_forward = found != modes_.by_port.end() && found->second.text("register_mode") == "forward";
    return is_forward ? modes_.least_fifo : 2;
  }

  struct Handshake {
    std::string data, valid, ready;
  };
  void fifo(const std::string& name, unsigned width, int depth, const Handshake& in, const Handshake& out,
            const char* module = "fifo") {
    body_ << "    " << module << " #(\n        .WIDTH(" << width << "),\n        .DEPTH(" << depth
          << ")\n    ) " << name << " (\n        .clk(ap_clk),\n        .rst(rst),\n        .s_data("
          << in.data << "),\n        .s_valid(" << in.valid << "),\n        .s_ready(" << in.ready
          << "),\n        .m_data(" << out.data << "),\n        .m_valid(" << out.valid
          << "),\n        .m_ready(" << out.ready << ")\n    );\n";
  }

  /// A single register hands the reader's readiness on to the writer; that must not run in a circle.
  static int depth_of(const RegionStream& stream) {
    return stream.writer < stream.reader ? stream.depth : std::max(2, stream.depth);
  }

  void add_fifo(const RegionStream& stream) {
    const std::string& name = stream.name;
    int depth = depth_of(stream);
    body_ << "\n    // " << name << ": " << depth << " x " << stream.width << "\n    wire"
          << range_text(stream.width) << " " << name << "_din, " << name << "_dout;\n    wire " << name
          << "_full_n, " << name << "_write, " << name << "_empty_n, " << name << "_read;\n";
    fifo(name + "_fifo", stream.width, depth, {name + "_din", name + "_write", name + "_full_n"},
         {name + "_dout", name + "_empty_n", name + "_read"});
    if (has_probes_) body_ << fifo_probe(name, depth);
  }

  const RegionStream& stream_between(const Region& region, const std::string& name) const {
    std::string names;
    for (const RegionStream& stream : region.streams) {
      if (stream.argument >= 0) continue;
      if (stream.name == name) return stream;
      names += (names.empty() ? "" : ", ") + stream.name;
    }
    throw CompileError("'" + top_.name + "' has no stream '" + name +
                       "' between its processes to tap; it has " + (names.empty() ? "none" : names));
  }

  void add_tap(const RegionStream& stream) {
    const std::string& name = stream.name;
    unsigned padded = (stream.width + 7) / 8 * 8;
    port("output", padded, name + "_tap_TDATA");
    port("output", 1, name + "_tap_TVALID");
    port("output", 1, name + "_tap_TREADY");
    body_ << "\n    // " << name << ": what its reader sees\n    assign " << name
          << "_tap_TDATA = " << resized_text(name + "_dout", stream.width, false, padded) << ";\n    assign "
          << name << "_tap_TVALID = " << name << "_empty_n;\n    assign " << name << "_tap_TREADY = " << name
          << "_read;\n";
  }

  static std::string member_name(const RegionChannel& channel, uint64_t byte_offset) {
    return channel.member_widths.size() == 1 ? channel.name
                                             : channel.name + "_at" + std::to_string(byte_offset);
  }

  /// Banks per member; a bank goes to the reader when the writer's run ends, and back when the reader's does,
  /// or by tokens (add_tokens).
  void add_channel(const RegionChannel& channel) {
    const std::string& name = channel.name;
    unsigned address = address_bits(channel.depth), bits = address_bits(channel.banks);
    std::string count = std::to_string(bits + 1) + "'d", number = std::to_string(bits) + "'";
    auto next = [&](const std::string& bank) {
      return bits == 1 ? "~" + bank : bank + " + " + number + "d1";
    };
    auto counted = [&](const std::string& event) {
      return "{" + std::to_string(bits) + "'b0, " + name + event + "}";
    };
    body_ << "\n    // " << name << ": " << (channel.banks == 2 ? "two" : std::to_string(channel.banks))
          << " banks of " << channel.depth << " elements\n";
    body_ << "    reg" << range_text(bits + 1) << " " << name
          << "_filled;  // banks that wait for the reader\n    reg" << range_text(bits) << " " << name
          << "_write_bank, " << name << "_read_bank;\n";
    body_ << "    wire " << name << "_written, " << name << "_taken;\n";
    body_ << "    wire " << name << "_free = (" << name << "_filled != " << count << channel.banks
          << ");\n    wire " << name << "_ready = (" << name << "_filled != " << count << "0);\n";
    body_ << "    always @(posedge ap_clk) begin\n        if (" << name << "_written) " << name
          << "_write_bank <= " << next(name + "_write_bank") << ";\n";
    body_ << "        if (" << name << "_taken) " << name << "_read_bank <= " << next(name + "_read_bank")
          << ";\n";
    body_ << "        " << name << "_filled <= " << name << "_filled + " << counted("_written") << " - "
          << counted("_taken") << ";\n";
    body_ << "        if (rst) begin\n            " << name << "_filled <= " << count << "0;\n            "
          << name << "_write_bank <= " << number << "b0;\n            " << name << "_read_bank <= " << number
          << "b0;\n        end\n    end\n";
    for (auto [byte_offset, width] : channel.member_widths) {
      std::string member = member_name(channel, byte_offset);
      body_ << "    wire" << range_text(address) << " " << member << "_write_address, " << member
            << "_read_address;\n    wire " << member << "_write, " << member << "_read;\n";
      body_ << "    wire" << range_text(width) << " " << member << "_d, " << member << "_q;\n";
      add_banks(channel, member, width, "_read", {member + "_banks", member + "_read", member + "_q"});
      if (!channel.read_back.count(byte_offset)) continue;
      body_ << "    wire" << range_text(address) << " " << member << "_back_address;\n    wire " << member
            << "_back;\n    wire" << range_text(width) << " " << member << "_back_q;\n";
      add_banks(channel, member, width, "_write",
                {member + "_back_banks", member + "_back", member + "_back_q"});
    }
  }

  /// Streams of hls::stream_of_blocks: the writer claims a free bank and fills it, the reader takes a filled
  /// one and gives it back.
  void add_tokens(const RegionStream& stream, const std::string& channel) {
    const std::string& name = stream.name;
    body_ << "\n    // " << name << ": tokens of " << channel << "'s banks, "
          << (stream.fills ? "filled" : "claimed") << "\n    wire " << name << "_din, " << name << "_write, "
          << name << "_read;\n    wire " << name << "_dout = 1'b0;\n";
    auto signal = [&](const char* suffix, const std::string& value) {
      body_ << "    wire " << name << suffix << " = " << value << ";\n";
    };
    signal("_full_n", stream.fills ? "1'b1" : channel + "_free");
    signal("_empty_n", stream.fills ? channel + "_ready" : "1'b1");
    body_ << "    assign " << channel << (stream.fills ? "_written" : "_taken") << " = " << name
          << (stream.fills ? "_write" : "_read") << ";\n";
  }

  struct BankReader {
    std::string ram, enable, data;
  };
  /// A member's banks as one side reads them: `side` is _read or _write.
  void add_banks(const RegionChannel& channel, const std::string& member, unsigned width,
                 const std::string& side, const BankReader& reader) {
    unsigned address = address_bits(channel.depth), bank = address_bits(channel.banks);
    body_ << "    ram_1r1w #(\n        .WIDTH(" << width << "),\n        .DEPTH("
          << (uint64_t{1} << (address + bank)) << "),\n        .ADDRESS_WIDTH(" << address + bank
          << ")\n    ) " << reader.ram << " (\n        .clk(ap_clk),\n        .write_enable(" << member
          << "_write),\n        .write_address({" << channel.name << "_write_bank, " << member
          << "_write_address}),\n        .write_data(" << member << "_d),\n        .read_enable("
          << reader.enable << "),\n        .read_address({" << channel.name << side << "_bank, "
          << reader.enable << "_address}),\n        .read_data(" << reader.data << ")\n    );\n";
  }

  /// Ports of an array that a process fills and none reads.
  static std::string unread(const std::string& memory) {
    std::string out;
    for (const char* port : {"_address0", "_ce0", "_we0", "_d0"})
      out += ",\n        ." + memory + port + "()";
    return out;
  }

  /// What an instance's address port is tied to: NAME_address, or a wider wire that is cut to it.
  std::string channel_address(const RegionChannel& channel, const ChannelPort& port,
                              const std::string& name) {
    unsigned inside = address_bits(channel.depth);
    if (port.address_width <= inside) return name + "_address";
    std::string wide = name + "_index";
    body_ << "    wire" << range_text(port.address_width) << " " << wide << ";\n    assign " << name
          << "_address = " << resized_text(wide, port.address_width, false, inside) << ";\n";
    return wide;
  }

  /// Connects the ports of an instance to its channels; gives the condition under which the instance may
  /// start.
  std::string channel_connections(const Region& region, const Instance& instance, size_t index,
                                  std::string& gate, std::string& ends) {
    std::ostringstream out;
    std::set<int> seen;
    for (const ChannelPort& port : instance.channels) {
      const RegionChannel& channel = region.channels[port.channel];
      if (channel.reader < 0) {
        out << unread(port.memory);
        continue;
      }
      bool writes = channel.writer == static_cast<int>(index);
      std::string member = member_name(channel, port.byte_offset), memory = ",\n        ." + port.memory;
      auto read = [&](const std::string& name, const std::string& data) {
        out << memory << "_address0(" << channel_address(channel, port, name) << ")" << memory << "_ce0("
            << name << ")" << memory << "_q0(" << data << ")";
      };
      if (port.reads_back) read(member + "_back", member + "_back_q");
      if (writes) {
        std::string number = port.reads_back ? "1" : "0";
        out << memory << "_address" << number << "(" << channel_address(channel, port, member + "_write")
            << ")" << memory << "_ce" << number << "()" << memory << "_we" << number << "(" << member
            << "_write)" << memory << "_d" << number << "(" << member << "_d)";
      } else {
        read(member + "_read", member + "_q");
      }
      if (channel.has_locks || !seen.insert(port.channel).second) continue;
      gate += " & " + channel.name + (writes ? "_free" : "_ready");
      ends +=
          "    assign " + channel.name + (writes ? "_written = " : "_taken = ") + instance.name + "_done;\n";
      if (has_probes_) ends += gate_probe(instance.name, channel.name, !writes);
    }
    return out.str();
  }

  // --- Scalars and memories ---

  void declare_region_scalar(const RegionScalar& scalar) {
    const std::string& name = scalar.name;
    body_ << "\n    // " << name << ": set by one process, taken by another\n    wire"
          << range_text(scalar.width) << " " << name << "_set, " << name << ";\n    wire " << name
          << "_free, " << name << "_ready;\n";
  }

  /// The first scalar that the same output sets: it has the wire of the instance's port.
  static const RegionScalar& first_of(const Region& region, int writer, int output) {
    return *std::find_if(region.scalars.begin(), region.scalars.end(), [&](const RegionScalar& scalar) {
      return scalar.writer == writer && scalar.output == output;
    });
  }

  /// A scalar from instance to instance waits in a FIFO from the end of the writer's run to that of the
  /// reader's.
  void add_region_scalar(const Region& region, const RegionScalar& scalar) {
    const std::string& name = scalar.name;
    const RegionScalar& first = first_of(region, scalar.writer, scalar.output);
    if (first.name != name) body_ << "    assign " << name << "_set = " << first.name << "_set;\n";
    fifo(name + "_runs", scalar.width, 4,
         {name + "_set", region.instances[scalar.writer].name + "_done", name + "_free"},
         {name, name + "_ready", region.instances[scalar.reader].name + "_done"});
  }

  /// Ports of an instance that scalars between instances are tied to; `gate` gets their conditions to start.
  static std::string region_scalar_ports(const Region& region, int index, const Process& process,
                                         std::string& gate) {
    std::string text;
    for (const RegionScalar& scalar : region.scalars) {
      if (scalar.writer == index) gate += " & " + scalar.name + "_free";
      if (scalar.reader != index) continue;
      gate += " & " + scalar.name + "_ready";
      const ScalarPort& port = process.scalars[scalar.input];
      text += ",\n        ." + port.name + "(" +
              resized_text(scalar.name, scalar.width, scalar.is_signed, port.width) + ")";
    }
    for (size_t i = 0; i < process.scalars.size(); ++i) {
      const ScalarPort& port = process.scalars[i];
      if (!port.is_output || region.instances[index].scalars[i] >= 0) continue;
      std::string wire;
      bool is_taken =
          std::any_of(region.scalars.begin(), region.scalars.end(), [&](const RegionScalar& scalar) {
            return scalar.writer == index && scalar.output == static_cast<int>(i);
          });
      if (is_taken) wire = first_of(region, index, i).name + "_set";
      text += ",\n        ." + port.name + "(" + wire + ")";
      if (port.has_valid()) text += ",\n        ." + port.name + "_ap_vld()";
    }
    return text;
  }

  void add_scalar(const ScalarPort& scalar) {
    std::string bank = modes_.bank(scalar.argument < 0 ? "return" : top_.parameters[scalar.argument].name);
    port_or_wire(bank, scalar.is_output ? "output" : "input", scalar.width, scalar.name);
    if (scalar.has_valid()) port_or_wire(bank, "output", 1, scalar.name + "_ap_vld");
    if (bank.empty())
      interface_.scalars.push_back(scalar);
    else
      bank_named(bank).registers.push_back({scalar});
  }

  /// `ties` name the memories of an instance as the top does.
  void add_memories(const Process& process, const std::vector<MemoryTie>& ties) {
    for (const Memory& memory : process.memories) {
      if (memory.kind != MemoryKind::kPort || (!memory.is_read && !memory.is_written)) continue;
      if (tied_.count(memory.name)) continue;
      InterfaceMemory outside;
      outside.name = memory.name;
      outside.width = memory.width;
      outside.depth = memory.depth;
      outside.argument = memory.argument;
      for (const MemoryTie& tie : ties)
        if (tie.memory == memory.name) {
          outside.argument = tie.argument;
          outside.name = tie.outside;
        }
      const Parameter& parameter = top_.parameters[outside.argument];
      outside.stride = memory.stride;
      for (const Leaf& leaf : parameter.layout.leaves)
        if (memory.is_aggregate || leaf.byte_offset == memory.byte_offset) outside.leaves.push_back(leaf);
      outside.is_read = memory.is_read;
      outside.is_written = memory.is_written;
      std::string bank = modes_.bank(parameter.name);
      for (size_t number = 0; number < memory.ports.size(); ++number) {
        auto add = [&](const char* direction, unsigned width, const char* signal) {
          std::string name = outside.name + signal + std::to_string(number);
          port_or_wire(bank, direction, width, name);
          return name;
        };
        InterfaceMemoryPort signals;
        signals.address = add("output", address_bits(memory.depth), "_address");
        signals.enable = add("output", 1, "_ce");
        if (memory.ports[number].reads) signals.read_data = add("input", memory.width, "_q");
        if (memory.ports[number].writes) {
          signals.write_enable = add("output", 1, "_we");
          signals.write_data = add("output", memory.width, "_d");
        }
        outside.ports.push_back(signals);
      }
      if (bank.empty())
        interface_.memories.push_back(outside);
      else
        bank_named(bank).arrays.push_back({outside});
    }
  }

  /// The ports of a process beside clock, reset and control, which have the same names outside.
  std::vector<std::string> ports_of(const Process& process) {
    std::vector<std::string> names = stream_ports_of(process);
    for (const ScalarPort& scalar : process.scalars) {
      names.push_back(scalar.name);
      if (scalar.has_valid()) names.push_back(scalar.name + "_ap_vld");
    }
    for (const std::string& name : memory_ports_of(process)) names.push_back(name);
    return names;
  }
  static std::vector<std::string> stream_ports_of(const Process& process) {
    std::vector<std::string> names;
    for (const Stream& stream : process.streams)
      for (const char* suffix : suffixes(stream.is_input)) names.push_back(stream.name + suffix);
    return names;
  }
  static std::vector<const char*> suffixes(bool is_input) {
    if (is_input) return {"_dout", "_empty_n", "_read"};
    return {"_din", "_full_n", "_write"};
  }
  std::vector<std::string> memory_ports_of(const Process& process) {
    std::vector<std::string> names;
    for (const Memory& memory : process.memories) {
      if (memory.kind != MemoryKind::kPort || tied_.count(memory.name)) continue;
      for (size_t number = 0; number < memory.ports.size(); ++number) {
        std::vector<const char*> suffixes = {"_address", "_ce"};
        if (memory.ports[number].reads) suffixes.push_back("_q");
        if (memory.ports[number].writes) suffixes.insert(suffixes.end(), {"_we", "_d"});
        for (const char* suffix : suffixes) names.push_back(memory.name + suffix + std::to_string(number));
      }
    }
    return names;
  }

  /// The top's name of an instance's memory port: NAME_address0 and so on.
  static std::string outside_port(const Instance& instance, const std::string& port) {
    size_t suffix = port.rfind('_');
    for (const MemoryTie& tie : instance.memories)
      if (tie.memory == port.substr(0, suffix)) return tie.outside + port.substr(suffix);
    return port;
  }

  // --- A dataflow region ---

  void add_head(const Region& region) {
    body_ << "\n    // Scalars of a run, taken when it starts.\n";
    for (const ScalarPort& scalar : region.run_scalars)
      body_ << "    wire" << range_text(scalar.width) << " " << scalar.name << ";\n";
    bool has_outputs = !region.run_scalars.empty();
    if (!interface_.has_start) body_ << "    wire ap_start = 1'b1;\n";
    head_is_combinational_ = is_combinational(region.head);
    body_ << "    wire starts_free, run_starts;\n";
    if (region.is_loop) return add_loop_head(region);
    if (!head_is_combinational_) body_ << "    wire head_done;\n";
    body_ << "    assign run_starts = " << run_is_there() << " & starts_free;\n";
    if (head_is_combinational_ && !has_outputs) return;
    body_ << "    " << region.head.name << " head (\n";
    std::string separator = "        ";
    if (!head_is_combinational_) {
      body_ << "        .clk(ap_clk),\n        .rst(rst),\n        .ap_start(ap_start),\n        "
               ".ap_continue(starts_free),\n        .ap_done(head_done),\n        .ap_idle(),\n        "
               ".ap_ready()";
      separator = ",\n        ";
    }
    add_head_scalars(region, separator);
    body_ << "\n    );\n";
  }

  void add_head_scalars(const Region& region, std::string separator) {
    std::set<int> by_instance = outputs_of_instances(region);
    for (size_t i = 0; i < region.head.scalars.size(); ++i) {
      if (by_instance.count(i)) continue;
      const ScalarPort& scalar = region.head.scalars[i];
      body_ << separator << "." << scalar.name << "(" << scalar.name << ")";
      separator = ",\n        ";
      if (scalar.has_valid())
        body_ << separator << "." << scalar.name << "_ap_vld(" << scalar.name << "_ap_vld)";
    }
  }

  /// The loop writes the scalars of a run when it starts one. It is done when it has ended and all its runs
  /// have.
  void add_loop_head(const Region& region) {
    const Stream& runs = region.head.streams[0];
    body_ << "    wire" << range_text(runs.width) << " runs;\n    wire head_done, head_idle, loop_ends;\n";
    unsigned low = 0;
    for (const ScalarPort& scalar : region.run_scalars) {
      body_ << "    assign " << scalar.name << " = " << bits_of("runs", runs.width, low, scalar.width)
            << ";\n";
      low += scalar.width;
    }
    body_ << "    " << region.head.name << " head (\n        .clk(ap_clk),\n        .rst(rst),\n        "
          << ".ap_start(ap_start),\n        .ap_continue(loop_ends),\n        .ap_done(head_done),\n        "
          << ".ap_idle(head_idle),\n        .ap_ready(),\n        ." << runs.name << "_din(runs),\n        ."
          << runs.name << "_full_n(starts_free),\n        ." << runs.name << "_write(run_starts)";
    add_head_scalars(region, ",\n        ");
    body_ << "\n    );\n";
  }

  static std::string bits_of(const std::string& name, unsigned bits, unsigned low, unsigned width) {
    if (bits == 1) return name;
    std::string high = width == 1 ? "" : std::to_string(low + width - 1) + ":";
    return name + "[" + high + std::to_string(low) + "]";
  }

  /// The scalars of the next run are there.
  const char* run_is_there() const { return head_is_combinational_ ? "ap_start" : "head_done"; }

  /// Outputs of the top that an instance drives, not the head.
  std::set<int> outputs_of_instances(const Region& region) const {
    std::set<int> driven;
    for (const Instance& instance : region.instances) {
      const std::vector<ScalarPort>& ports = processes_[instance.process]->scalars;
      for (size_t i = 0; i < ports.size(); ++i)
        if (ports[i].is_output && instance.scalars[i] >= 0) driven.insert(instance.scalars[i]);
    }
    return driven;
  }

  static bool is_taken_at_start(const Instance& instance, const Process& process, size_t scalar) {
    return !process.scalars[scalar].is_output && instance.scalars[scalar] >= 0;
  }

  /// Bits of the scalars that all instances take.
  static unsigned bits_taken(const Region& region, const std::vector<const Process*>& processes) {
    unsigned bits = 0;
    for (const Instance& instance : region.instances) {
      const Process& process = *processes[instance.process];
      for (size_t i = 0; i < process.scalars.size(); ++i)
        if (is_taken_at_start(instance, process, i)) bits += process.scalars[i].width;
    }
    return bits;
  }

  /// Without a start from outside, and with streams alone between them, instances need not wait for each
  /// other.
  bool runs_freely(const Region& region) const {
    bool has_banks_of_runs = std::any_of(region.channels.begin(), region.channels.end(),
                                         [](const RegionChannel& channel) { return !channel.has_locks; });
    bool has_runs = interface_.has_start || region.is_loop || !region.head.scalars.empty() ||
                    !region.scalars.empty() || has_banks_of_runs;
    return !has_runs;
  }

  bool runs_freely(const Instance& instance, const Region& region) const {
    return instance.is_task || runs_freely(region);
  }

  /// What starts the run of an instance: the FIFO that holds the scalars of its runs. They stay at its output
  /// until the instance is done, or where its runs overlap until it `begins` one.
  void add_starts(const std::string& name, const std::string& data, unsigned width, const std::string& taken,
                  const std::string& begins) {
    Handshake out = {taken, name + "_start", begins.empty() ? name + "_done" : begins};
    std::string ready = name + "_start_free";
    if (has_registers_)
      fifo(name + "_starts", std::max(1u, width), 1,
           {data, "run_waits & ~taken[" + std::to_string(dones_.size()) + "]", ready}, out);
    else if (width >= kWideScalars)
      fifo(name + "_starts", width, runs_overlap_ ? kOverlappingRuns : 4, {data, "run_starts", ready}, out,
           "scalar_fifo");
    else
      fifo(name + "_starts", std::max(1u, width), runs_overlap_ ? kOverlappingRuns : 2,
           {data, "run_starts", ready}, out);
    dones_.push_back(name + "_done");
    frees_.push_back(ready);
  }

  void add_instance(const Region& region, size_t index, const Process& process) {
    const Instance& instance = region.instances[index];
    const std::string& name = instance.name;
    const bool overlaps = process.call_loop() >= 0;
    std::vector<std::string> inputs;
    unsigned width = 0;
    for (size_t i = 0; i < process.scalars.size(); ++i) {
      if (!is_taken_at_start(instance, process, i)) continue;
      inputs.push_back(region.run_scalars[instance.scalars[i]].name);
      width += process.scalars[i].width;
    }
    bool is_free = runs_freely(instance, region);
    std::string start = is_free ? "1'b1" : name + "_start", done = is_free ? "" : name + "_done";
    body_ << "\n";
    std::string begins = is_free || !overlaps ? "" : name + "_begins";
    if (!is_free) body_ << "    wire " << start << ", " << done << ", " << name << "_start_free;\n";
    if (!begins.empty()) body_ << "    wire " << begins << ";\n";
    std::string data = "1'b0", taken;
    if (width) {
      taken = name + "_scalars";
      body_ << "    wire" << range_text(width) << " " << taken << ";\n";
      data = "{";
      for (size_t i = inputs.size(); i-- > 0;) data += inputs[i] + (i ? ", " : "}");
    }
    if (!is_free) add_starts(name, data, width, taken, begins);
    tied_.clear();
    for (const ChannelPort& tie : instance.channels) tied_.insert(tie.memory);
    std::string gate = start, ends;
    std::string tied_ports = channel_connections(region, instance, index, gate, ends) +
                             region_scalar_ports(region, index, process, gate);
    body_ << ends << "    " << process.name << " " << name
          << " (\n        .clk(ap_clk),\n        .rst(rst),\n";
    body_ << "        .ap_start(" << gate << "),\n        .ap_continue(1'b1),\n        .ap_done(" << done
          << "),\n";
    body_ << "        .ap_idle(),\n        .ap_ready(" << begins << ")" << tied_ports;
    for (size_t i = 0; i < process.streams.size(); ++i)
      for (const char* suffix : suffixes(process.streams[i].is_input))
        body_ << ",\n        ." << process.streams[i].name << suffix << "("
              << region.streams[instance.streams[i]].name << suffix << ")";
    unsigned low = 0;
    for (size_t i = 0; i < process.scalars.size(); ++i) {
      if (instance.scalars[i] < 0) continue;
      const ScalarPort& scalar = process.scalars[i];
      if (scalar.is_output) {
        const std::string& outside = region.head.scalars[instance.scalars[i]].name;
        body_ << ",\n        ." << scalar.name << "(" << outside << ")";
        if (scalar.has_valid()) body_ << ",\n        ." << scalar.name << "_ap_vld(" << outside << "_ap_vld)";
        continue;
      }
      body_ << ",\n        ." << scalar.name << "(" << bits_of(taken, width, low, scalar.width) << ")";
      low += scalar.width;
    }
    add_memories(process, instance.memories);
    for (const std::string& memory_port : memory_ports_of(process))
      body_ << ",\n        ." << memory_port << "(" << outside_port(instance, memory_port) << ")";
    body_ << "\n    );\n";
    for (size_t i = 0; i < process.streams.size() && has_probes_; ++i)
      body_ << end_probe(name, process.streams[i].name, region.streams[instance.streams[i]].name,
                         process.streams[i].is_input);
  }

  /// Counts the runs each instance has finished; the region's run is done when all have finished it. A loop's
  /// runs are no calls of the top.
  void add_run_control(bool is_loop) {
    size_t count = dones_.size();
    std::string free, all;
    body_ << "\n    // Runs that an instance has finished and the region has not; at most " << most_runs()
          << " are under way.\n";
    std::string range = range_text(run_bits()), none = counted(0);
    for (size_t i = 0; i < count; ++i) {
      std::string counter = "finished_" + std::to_string(i);
      body_ << "    reg" << range << " " << counter << ";\n";
      free += (i ? " & " : "") + frees_[i];
      all += (i ? " & " : "") + ("(" + counter + " != " + none + ")");
    }
    std::string proceed = interface_.has_continue ? "ap_continue" : "1'b1";
    body_ << "    reg" << range << " under_way;\n";
    if (has_registers_)
      add_taking(count);
    else
      body_ << "    assign starts_free = " << free << " & " << run_fits() << ";\n";
    body_ << "    wire run_done = " << all << ";\n    wire run_leaves = run_done & "
          << (is_loop ? "1'b1" : proceed) << ";\n";
    if (is_loop) {
      body_ << "    wire loop_done = head_done & (under_way == " << none
            << ");\n    assign loop_ends = loop_done & " << proceed << ";\n";
      if (interface_.has_start)
        body_ << "    assign ap_done = loop_done;\n    assign ap_ready = loop_ends;\n    assign ap_idle = "
                 "head_idle;\n";
    } else if (interface_.has_start)
      body_ << "    assign ap_done = run_done;\n    assign ap_ready = run_starts;\n    assign ap_idle = "
            << "(under_way == " << none << ");\n";
    std::string zeros = "{" + std::to_string(run_bits() - 1) + "'d0, ";
    auto count_runs = [&](const std::string& counter, const std::string& up) {
      body_ << "        " << counter << " <= " << counter << " + " << zeros << up << "} - " << zeros
            << "run_leaves};\n";
    };
    body_ << "    always @(posedge ap_clk) begin\n";
    for (size_t i = 0; i < count; ++i) count_runs("finished_" + std::to_string(i), dones_[i]);
    count_runs("under_way", "run_starts");
    body_ << "        if (rst) begin\n            under_way <= " << none << ";\n";
    for (size_t i = 0; i < count; ++i) body_ << "            finished_" << i << " <= " << none << ";\n";
    body_ << "        end\n    end\n";
  }

  void add_bank(const AxiliteBank& bank) {
    for (const BankPort& signal : bus_ports(bank))
      port(signal.is_input ? "input" : "output", signal.width, signal.name);
    if (bank.has_control) port("output", 1, "interrupt");
    body_ << "\n    " << axilite_module(top_.name, bank) << " " << bank.name
          << "_registers (\n        .clk(ap_clk),\n        .rst(rst)";
    for (const std::vector<BankPort>& signals : {bus_ports(bank), inner_ports(bank)})
      for (const BankPort& signal : signals)
        body_ << ",\n        ." << signal.name << "(" << signal.name << ")";
    body_ << "\n    );\n";
  }

  /// Counters of runs: two may overlap where instances have registers, and one more that all have finished.
  unsigned run_bits() const {
    if (has_registers_) return 2;
    return runs_overlap_ ? address_bits(kOverlappingRuns) : 3;
  }
  unsigned most_runs() const { return (1u << run_bits()) - 1; }
  std::string counted(unsigned runs) const {
    return std::to_string(run_bits()) + "'d" + std::to_string(runs);
  }
  std::string run_fits() const { return "(under_way != " + counted(most_runs()) + ")"; }

  /// Each instance takes the scalars of the next run when its register is free; they stay where they are
  /// until all have them.
  void add_taking(size_t count) {
    std::string free;
    for (size_t i = count; i-- > 0;) free += frees_[i] + (i ? ", " : "");
    std::string none = std::to_string(count) + "'d0";
    body_ << "    wire" << range_text(count) << " takes = taken | {" << free
          << "};\n    assign run_waits = " << run_is_there() << " & " << run_fits()
          << ";\n    assign starts_free = (&takes) & " << run_fits()
          << ";\n    always @(posedge ap_clk) begin\n        if (run_starts | rst) taken <= " << none
          << ";\n        else if (run_waits) taken <= takes;\n    end\n";
  }

  TopModule finished() {
    std::map<std::string, std::string> bank_files;
    for (AxiliteBank& bank : interface_.banks) {
      place_registers(bank);
      add_bank(bank);
      bank_files[axilite_module(top_.name, bank) + ".v"] = emit_axilite(top_.name, bank);
    }
    if (!bank_files.empty())
      bank_files["x" + top_.name + "_hw.h"] = axilite_header(top_.name, interface_.banks);
    std::ostringstream out;
    out << (interface_.control_bank() ? kInterruptName : "") << "// " << top_.name << ": top of the design, "
        << top_.qualified << ". Generated by floorline-hlsc; do not edit.\n\n`default_nettype none\n\nmodule "
        << top_.name << " (\n"
        << ports_.str() << "\n);\n\n"
        << wires_.str() << body_.str() << "\nendmodule\n\n`default_nettype wire\n";
    return {out.str(), bank_files, interface_};
  }

  const FunctionInfo& top_;
  const PortModes& modes_;
  const bool has_probes_;
  TopInterface interface_;
  bool head_is_combinational_ = false;
  bool runs_overlap_ = false;              ///< An instance begins a run before it has ended the one before.
  bool has_registers_ = false;             ///< Of the instances' scalars, in place of FIFOs.
  std::set<std::string> tied_;             ///< Memory ports of the instance at hand that lead to a channel.
  std::vector<const Process*> processes_;  ///< Of a region.
  std::vector<std::string> dones_, frees_;
  std::ostringstream ports_, wires_, body_;  ///< wires_: to the banks.
};

}  // namespace

TopModule emit_single_top(const FunctionInfo& top, const Process& process, const PortModes& modes,
                          bool has_probes) {
  // A co-simulation starts overlapping calls that nothing outside can hold back, so that a call is one run.
  PortModes told = modes;
  bool is_free = modes.mode("return") == "ap_ctrl_none" && process.streams.empty();
  if (has_probes && is_free && process.call_loop() >= 0)
    told.by_port["return"].options["mode"] = "ap_ctrl_hs";
  return TopWriter(top, told, has_probes).single(process);
}

TopModule emit_dataflow_top(const FunctionInfo& top, const Region& region,
                            const std::vector<const Process*>& processes, const PortModes& modes,
                            const std::vector<std::string>& taps, bool has_probes) {
  return TopWriter(top, modes, has_probes).dataflow(region, processes, taps);
}

}  // namespace hlsc
