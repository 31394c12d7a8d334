#include "differential/expectation.h"

#include <fmt/format.h>

#include <regex>
#include <stdexcept>

namespace hlsc::differential {
namespace {

struct ScheduledLoop {
  const Block* block = nullptr;
  const BlockSchedule* schedule = nullptr;
};

ScheduledLoop loop_on_line(const CompileResult& compiled, unsigned line) {
  for (const CompiledProcess& process : compiled.processes)
    for (std::size_t i = 0; i < process.process.blocks.size(); ++i) {
      const Block& block = process.process.blocks[i];
      if (block.is_loop && block.location.line == line) return {&block, &process.schedule.blocks[i]};
    }
  return {};
}

std::string check_loop(const CompileResult& compiled, unsigned line, const std::string& wanted) {
  ScheduledLoop loop = loop_on_line(compiled, line);
  if (wanted == "unrolled") return loop.block ? "the loop is not unrolled" : "";
  std::smatch match;
  if (!std::regex_match(wanted, match, std::regex("II=(\\d+)(?: depth=(\\d+))?")))
    throw std::runtime_error(
        fmt::format("cannot read `expect: loop {}`; write II=N depth=N or unrolled.", wanted));
  if (!loop.block) return "there is no pipelined loop";
  if (loop.schedule->ii != std::stoi(match[1])) return fmt::format("II is {}", loop.schedule->ii);
  if (match[2].matched && loop.schedule->length != std::stoi(match[2]))
    return fmt::format("depth is {}", loop.schedule->length);
  return "";
}

const char* name_of(MemoryKind kind) {
  switch (kind) {
    case MemoryKind::kRegisters:
      return "registers";
    case MemoryKind::kRam:
      return "ram";
    case MemoryKind::kRom:
      return "rom";
    default:
      return "port";
  }
}

/// A partitioned array is several memories, NAME_0 and so on. `wanted`: a kind, or kind and shape.
std::string check_memory(const CompileResult& compiled, const std::string& name, const std::string& wanted) {
  std::string found = "none";
  for (const CompiledProcess& process : compiled.processes)
    for (const Memory& memory : process.process.memories) {
      bool is_meant = memory.name == name || memory.name.rfind(name + "_", 0) == 0;
      if (!is_meant || !(memory.is_read || memory.is_written)) continue;
      std::string kind = name_of(memory.kind);
      found = fmt::format("{} {}x{}", kind, memory.depth, memory.width);
      if (wanted == kind || wanted == found) return "";
    }
  return found == wanted ? "" : fmt::format("memory {} is {}", name, found);
}

std::string check(const CompileResult& compiled, const Statement& statement) {
  static const std::regex kForm("(loop) (.*)|memory (\\w+) (\\w+(?: \\d+x\\d+)?)");
  std::smatch match;
  if (!std::regex_match(statement.text, match, kForm))
    throw std::runtime_error(fmt::format(
        "cannot read `expect: {}`; write loop ... or memory NAME KIND DEPTHxWIDTH.", statement.text));
  return match[1].matched ? check_loop(compiled, statement.line, match[2])
                          : check_memory(compiled, match[3], match[4]);
}

}  // namespace

std::string failed_expectation(const CompileResult& compiled, const Steering& steering) {
  for (const Statement& statement : steering.expectations) {
    std::string failure = check(compiled, statement);
    if (!failure.empty())
      return fmt::format("line {}: expect: {}: {}", statement.line, statement.text, failure);
  }
  return "";
}

}  // namespace hlsc::differential
