#include <algorithm>

#include "verilog/process_emitter.h"
#include "verilog/text.h"

namespace hlsc {
namespace {

/// Address bits of the longest RAM that Virtex-6 makes without logic: two RAMB36E1 in cascade hold 64K x 1.
constexpr unsigned kCascadeAddress = 16;

constexpr size_t kTermsInLine = 256;

/// The elements of a concatenation, the last one in the highest bits.
std::string last_first(const std::map<int, std::string>& elements) {
  std::string out;
  for (const auto& [index, element] : elements) out = element + (out.empty() ? "" : ", ") + out;
  return out;
}

}  // namespace

void ProcessEmitter::emit_memory(size_t index) {
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

std::vector<ValueId> ProcessEmitter::of_kind(const std::vector<ValueId>& accesses, OpKind kind) const {
  std::vector<ValueId> users;
  for (ValueId id : accesses)
    if (process_[id].kind == kind) users.push_back(id);
  return users;
}

std::vector<ValueId> ProcessEmitter::in_order_of_choice(std::vector<ValueId> accesses) const {
  auto is_older = [&](ValueId a, ValueId b) {
    return std::pair(-schedule_.start[a], a) < std::pair(-schedule_.start[b], b);
  };
  if (process_.call_loop() >= 0) std::sort(accesses.begin(), accesses.end(), is_older);
  return accesses;
}

ProcessEmitter::PortSignals ProcessEmitter::port_of(const Memory& memory,
                                                    const std::vector<ValueId>& accesses) {
  PortSignals port;
  const std::vector<ValueId> users = in_order_of_choice(accesses);
  for (size_t i = 0; i < users.size(); ++i) {
    const Operation& op = process_[users[i]];
    bool is_load = op.kind == OpKind::kLoad, is_last = i + 1 == users.size();
    Place at{op.block, schedule_.start[users[i]]};
    std::string when = is_load ? happens(at) : happens(op, at);
    for (int stage = 1; is_load && stage < static_cast<int>(memory.load_latency); ++stage)
      port.advance[stage] += (i ? " | (" : "(") + happens({op.block, at.cycle + stage}) + ")";
    // Verilator refuses lines of some ten thousand words.
    std::string end_of_line = i % kTermsInLine == kTermsInLine - 1 ? "\n            " : "";
    port.enable += (i ? " | " : "") + (users.size() > 1 ? "(" + when + ")" : when) + end_of_line;
    std::string wish =
        active(at) + (op.predicate != kNoValue && !is_load ? " & " + bit(op.predicate, at) : "");
    std::string choice = is_last ? "" : wish + " ? ", otherwise = is_last ? "" : " : ";
    otherwise += end_of_line;
    port.address += choice + text(op.operands[0], address_bits(memory.depth), at) + otherwise;
    if (!is_load) port.data += choice + text(op.operands[1], memory.width, at) + otherwise;
  }
  return port;
}

void ProcessEmitter::emit_ram(const Memory& memory, const std::vector<ValueId>& accesses) {
  PortSignals write = port_of(memory, of_kind(accesses, OpKind::kStore)),
              read = port_of(memory, of_kind(accesses, OpKind::kLoad));
  unsigned address = address_bits(memory.depth);
  const std::string& name = memory.name;
  if (read.enable.empty()) return;
  registers_ << "    wire" << range_text(memory.width) << " " << name << "_q;\n";
  auto or_zero = [](const std::string& value, unsigned width) {
    return value.empty() ? std::to_string(width) + "'d0" : value;
  };
  bool is_far = memory.load_latency > 1;
  bool is_deep = !is_far && address > kCascadeAddress && memory.starts_as_zero();
  if (memory.initial.empty() || is_far || is_deep) {
    std::string module = is_far ? "far_ram" : "ram_1r1w";
    if (is_deep) module = "deep_ram";
    bodies_ << "\n    " << module << " #(\n        .WIDTH(" << memory.width << "),\n        .DEPTH("
            << memory.depth << "),\n        .ADDRESS_WIDTH(" << address << ")";
    if (is_deep) bodies_ << ",\n        .BLOCK_ADDRESS(" << kCascadeAddress << ")";
    bodies_ << "\n    ) " << name << " (\n        .clk(clk),\n        .write_enable("
            << or_zero(write.enable, 1) << "),\n        .write_address(" << or_zero(write.address, address)
            << "),\n        .write_data(" << or_zero(write.data, memory.width) << "),\n        .read_enable("
            << read.enable << "),\n        .read_address(" << read.address << "),\n";
    if (is_far) bodies_ << "        .advance({" << last_first(read.advance) << "}),\n";
    bodies_ << "        .read_data(" << name << "_q)\n    );\n";
    return;
  }
  std::string array = names_.unique(name + "_words"), q = names_.unique(name + "_read");
  // What a read of the word being written gives is never used: the scheduler keeps both apart.
  std::string attribute = memory.is_block_table ? "ram_style = \"block\"" : "no_rw_check";
  bodies_ << "\n    (* " << attribute << " *)\n    reg" << range_text(memory.width) << " " << array
          << " [0:" << memory.depth - 1 << "];\n    reg" << range_text(memory.width) << " " << q
          << ";\n    assign " << name << "_q = " << q << ";\n";
  emit_initial_words(memory, array);
  bodies_ << "    always @(posedge clk) begin\n";
  if (!write.enable.empty())
    bodies_ << "        if (" << write.enable << ") " << array << "[" << write.address
            << "] <= " << write.data << ";\n";
  bodies_ << "        if (" << read.enable << ") " << q << " <= " << array << "[" << read.address
          << "];\n    end\n";
}

void ProcessEmitter::emit_initial_words(const Memory& memory, const std::string& array) {
  bool is_zero = memory.initial.size() == 1 && memory.initial[0].isZero();
  std::string index = names_.unique(memory.name + "_index");
  if (is_zero || memory.initial.size() == 1) {
    bodies_ << (is_zero ? "    // synthesis translate_off\n" : "") << "    integer " << index
            << ";\n    initial\n        for (" << index << " = 0; " << index << " < " << memory.depth << "; "
            << index << " = " << index << " + 1)\n            " << array << "[" << index
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

void ProcessEmitter::emit_table(const Memory& memory) {
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

void ProcessEmitter::emit_register_memory(const Memory& memory, const std::vector<ValueId>& accesses) {
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

void ProcessEmitter::emit_memory_port(const Memory& memory, const std::vector<ValueId>& accesses) {
  auto output = [&](const std::string& name, unsigned width, const std::string& value) {
    ports_ << ",\n    output wire" << range_text(width) << " " << name;
    bodies_ << "    assign " << name << " = " << value << ";\n";
  };
  bodies_ << "\n";
  for (int number = 0; number < static_cast<int>(memory.ports.size()); ++number) {
    std::vector<ValueId> users;
    for (ValueId id : accesses)
      if (schedule_.port[id] == number) users.push_back(id);
    PortSignals port = port_of(memory, users), write = port_of(memory, of_kind(users, OpKind::kStore));
    auto signal = [&](const char* suffix) { return memory.name + suffix + std::to_string(number); };
    output(signal("_address"), address_bits(memory.depth), port.address);
    output(signal("_ce"), 1, port.enable);
    if (memory.ports[number].reads)
      ports_ << ",\n    input wire" << range_text(memory.width) << " " << signal("_q");
    if (!memory.ports[number].writes) continue;
    output(signal("_we"), 1, write.enable);
    output(signal("_d"), memory.width, write.data);
  }
}

}  // namespace hlsc
