#include "differential/expectation.h"

#include <fmt/format.h>

#include <map>
#include <regex>
#include <stdexcept>

namespace hlsc::differential {
namespace {

[[noreturn]] void cannot_read(const std::string& text) {
  throw std::runtime_error(
      fmt::format("cannot read `expect: {}`; the forms are in compiler/test/corpus/README.md.", text));
}

const LoopReport* loop_on_line(const Report& report, unsigned line) {
  for (const ModuleReport& module : report.modules)
    for (const LoopReport& loop : module.loops)
      if (loop.location.line == line) return &loop;
  return nullptr;
}

/// `unrolled`, `sequential`, or `II=N`, `depth=N`, `cycles=FORMULA` and last `because TEXT`.
std::string check_loop(const Report& report, unsigned line, const std::string& wanted) {
  const LoopReport* loop = loop_on_line(report, line);
  if (wanted == "unrolled") return loop ? "the loop is not unrolled" : "";
  if (!loop) return "there is no loop";
  if (wanted == "sequential") return loop->is_pipelined ? "the loop is a pipeline" : "";
  if (!loop->is_pipelined) return "the loop is no pipeline";
  static const std::regex kForm("II=(\\d+)(?: depth=(\\d+))?(?: cycles=(\\S+))?(?: because (.*))?");
  std::smatch match;
  if (!std::regex_match(wanted, match, kForm)) cannot_read("loop " + wanted);
  if (loop->ii != std::stoi(match[1])) return fmt::format("II is {} ({})", loop->ii, loop->limit);
  if (match[2].matched && loop->stages != std::stoi(match[2]))
    return fmt::format("depth is {}", loop->stages);
  if (match[3].matched && loop->latency.text() != match[3])
    return fmt::format("it takes {} cycles", loop->latency.text());
  if (match[4].matched && loop->limit.find(match[4]) == std::string::npos)
    return fmt::format("the limit is '{}'", loop->limit);
  return "";
}

/// `NAME KIND [WORDSxBITS] [count=N]`. A partitioned array is several memories, NAME_0 and so on.
std::string check_memory(const Report& report, const std::string& wanted) {
  static const std::regex kForm("(\\w+) (\\w+)(?: (\\d+x\\d+))?(?: count=(\\d+))?");
  std::smatch match;
  if (!std::regex_match(wanted, match, kForm)) cannot_read("memory " + wanted);
  const std::string name = match[1], kind = match[2];
  std::string found;
  int count = 0;
  for (const ModuleReport& module : report.modules)
    for (const MemoryReport& memory : module.memories) {
      if (memory.name != name && memory.name.rfind(name + "_", 0) != 0) continue;
      std::string shape = fmt::format("{}x{}", memory.words, memory.bits);
      found += fmt::format(" {} {},", memory.kind, shape);
      count += memory.kind == kind && (!match[3].matched || match[3] == shape);
    }
  if (kind == "none") return found.empty() ? "" : "there is" + found;
  bool holds = match[4].matched ? count == std::stoi(match[4]) : count > 0;
  return holds ? "" : fmt::format("memories {} are{}", name, found.empty() ? " none" : found);
}

/// `KIND=N ...`: how many operators of a kind all modules have together.
std::string check_operators(const Report& report, const std::string& wanted) {
  std::map<std::string, int> counts;
  for (const ModuleReport& module : report.modules)
    for (const OperatorReport& op : module.operators) counts[op.kind] += op.count;
  static const std::regex kForm("(\\w+)=(\\d+)");
  auto begin = std::sregex_iterator(wanted.begin(), wanted.end(), kForm);
  if (begin == std::sregex_iterator()) cannot_read("operators " + wanted);
  for (auto one = begin; one != std::sregex_iterator(); ++one)
    if (counts[(*one)[1]] != std::stoi((*one)[2]))
      return fmt::format("{} operators: {}", counts[(*one)[1]], (*one)[1].str());
  return "";
}

/// `FORMULA`: from start to done of the only module.
std::string check_latency(const Report& report, const std::string& wanted) {
  std::string text = report.modules.size() == 1 ? report.modules[0].latency.text() : "of several modules";
  return text == wanted ? "" : fmt::format("latency is {}", text);
}

std::string check(const Report& report, const Statement& statement) {
  const std::string& text = statement.text;
  std::string kind = text.substr(0, text.find(' ')),
              rest = text.substr(std::min(kind.size() + 1, text.size()));
  if (kind == "loop") return check_loop(report, statement.line, rest);
  if (kind == "memory") return check_memory(report, rest);
  if (kind == "operators") return check_operators(report, rest);
  if (kind == "latency") return check_latency(report, rest);
  cannot_read(text);
}

}  // namespace

std::string failed_expectation(const Report& report, const Steering& steering) {
  for (const Statement& statement : steering.expectations) {
    std::string failure = check(report, statement);
    if (!failure.empty())
      return fmt::format("line {}: expect: {}: {}", statement.line, statement.text, failure);
  }
  return "";
}

}  // namespace hlsc::differential
