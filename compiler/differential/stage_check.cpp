#include "differential/stage_check.h"

#include <fmt/format.h>
#include <llvm/ADT/StringExtras.h>

#include <fstream>

#include "design/interpret.h"
#include "differential/native_program.h"

namespace hlsc::differential {
namespace {

using llvm::APInt;
using Words = std::vector<APInt>;

Words read_words(const std::filesystem::path& path, unsigned width) {
  Words words;
  std::ifstream in(path);
  for (std::string text; in >> text;)
    words.push_back(APInt(4 * static_cast<unsigned>(text.size()), text, 16).zextOrTrunc(width));
  return words;
}

std::string text_of(const APInt& word) { return llvm::toString(word, 16, false); }

/// The records of a case, and a process that is run on them call by call.
class StageRun {
 public:
  StageRun(const CompileResult& compiled, const Steering& steering, const std::filesystem::path& work,
           const Process& process, const ProcessSchedule* schedule)
      : compiled_(compiled),
        ports_(compiled.interface),
        steering_(steering),
        work_(work),
        process_(process),
        interpreter_(process, schedule) {
    around_.inputs.resize(process.streams.size());
    around_.outputs.resize(process.streams.size());
    around_.memories.resize(process.memories.size());
    for (const ScalarPort& port : process.scalars) around_.scalars.emplace_back(port.width, 0);
  }

  /// What differs first; empty when nothing does.
  std::string difference() {
    for (int call = 0; call < steering_.calls; ++call) {
      give(call);
      interpreter_.run(around_);
      std::string wrong = compare(call);
      if (!wrong.empty()) return fmt::format("call {}: {}", call, wrong);
    }
    return "";
  }

 private:
  std::filesystem::path file(const std::string& kind, size_t index, const char* role) const {
    return work_ / fmt::format("{}_{}_{}", kind, index, role);
  }

  /// First and last token of a call in the record of a stream.
  std::pair<size_t, size_t> tokens_of(size_t stream, int call) const {
    Words ends = read_words(file("stream", stream, "end"), 64);
    return {call ? ends.at(call - 1).getZExtValue() : 0, ends.at(call).getZExtValue()};
  }

  int memory_named(const std::string& name) const {
    for (size_t i = 0; i < process_.memories.size(); ++i)
      if (process_.memories[i].name == name) return i;
    throw std::runtime_error("there is no memory '" + name + "'");
  }

  Words contents(size_t memory, int call, const char* moment) const {
    const InterfaceMemory& port = ports_.memories[memory];
    Words all = read_words(file("memory", memory, moment), port.width);
    size_t count = element_count(compiled_, steering_, port.argument);
    return Words(all.begin() + call * count, all.begin() + (call + 1) * count);
  }

  void give(int call) {
    for (size_t i = 0; i < ports_.streams.size(); ++i) {
      around_.outputs[i].clear();
      if (!ports_.streams[i].is_input) continue;
      Words all = read_words(file("stream", i, "hex"), ports_.streams[i].width);
      auto [first, last] = tokens_of(i, call);
      around_.inputs[i].insert(around_.inputs[i].end(), all.begin() + first, all.begin() + last);
    }
    for (size_t i = 0; i < ports_.memories.size(); ++i)
      around_.memories[memory_named(ports_.memories[i].name)] = contents(i, call, "before");
    for (size_t i = 0; i < ports_.scalars.size(); ++i) {
      const ScalarPort& port = ports_.scalars[i];
      if (port.is_result) continue;
      around_.scalars[i] =
          read_words(file("scalar", i, port.is_output ? "before" : "hex"), port.width).at(call);
    }
  }

  std::string compare(int call) const {
    for (size_t i = 0; i < ports_.streams.size(); ++i) {
      if (ports_.streams[i].is_input) continue;
      Words all = read_words(file("stream", i, "hex"), ports_.streams[i].width);
      auto [first, last] = tokens_of(i, call);
      std::string wrong = differing(around_.outputs[i], Words(all.begin() + first, all.begin() + last));
      if (!wrong.empty()) return fmt::format("stream {} {}", ports_.streams[i].name, wrong);
    }
    for (size_t i = 0; i < ports_.memories.size(); ++i) {
      const std::string& name = ports_.memories[i].name;
      std::string wrong = differing(around_.memories[memory_named(name)], contents(i, call, "after"));
      if (!wrong.empty()) return fmt::format("array {} {}", name, wrong);
    }
    for (size_t i = 0; i < ports_.scalars.size(); ++i) {
      const ScalarPort& port = ports_.scalars[i];
      if (!port.is_output) continue;
      std::string digits = value_mask(compiled_, port);
      APInt mask = APInt(4 * static_cast<unsigned>(digits.size()), digits, 16).zextOrTrunc(port.width);
      APInt wanted = read_words(file("scalar", i, "hex"), port.width).at(call) & mask;
      APInt got = around_.scalars[i] & mask;
      if (got != wanted) return fmt::format("{} is {} and not {}", port.name, text_of(got), text_of(wanted));
    }
    return "";
  }

  static std::string differing(const Words& got, const Words& wanted) {
    if (got.size() != wanted.size()) return fmt::format("has {} words and not {}", got.size(), wanted.size());
    for (size_t i = 0; i < got.size(); ++i)
      if (got[i] != wanted[i])
        return fmt::format("word {} is {} and not {}", i, text_of(got[i]), text_of(wanted[i]));
    return "";
  }

  const CompileResult& compiled_;
  const TopInterface& ports_;
  const Steering& steering_;
  std::filesystem::path work_;
  const Process& process_;
  Interpreter interpreter_;
  Surroundings around_;
};

bool has_endless_loop(const Process& process) {
  for (size_t i = 0; i < process.blocks.size(); ++i) {
    const Terminator& terminator = process.blocks[i].terminator;
    if (!process.blocks[i].takes_calls && terminator.kind == Terminator::kJump &&
        terminator.targets[0] <= static_cast<int>(i))
      return true;
  }
  return false;
}

}  // namespace

StageObserver StageCheck::observer() {
  return [this](const std::string& name, const Process& process, const ProcessSchedule* schedule) {
    stages_.push_back({name, process, schedule ? *schedule : ProcessSchedule(), schedule != nullptr});
  };
}

std::string StageCheck::wrong_stage(const CompileResult& compiled, const Steering& steering,
                                    const std::filesystem::path& work) const {
  bool is_region = false;
  for (const Stage& stage : stages_) is_region |= stage.process.name != stages_[0].process.name;
  if (is_region || !compiled.interface.has_start) return "";
  for (const Stage& stage : stages_) {
    if (has_endless_loop(stage.process)) return "";
    std::string wrong;
    try {
      StageRun run(compiled, steering, work, stage.process, stage.is_scheduled ? &stage.schedule : nullptr);
      wrong = run.difference();
    } catch (const std::runtime_error& fault) {
      wrong = fault.what();
    }
    if (!wrong.empty()) return fmt::format("stage '{}': {}", stage.name, wrong);
  }
  return "";
}

}  // namespace hlsc::differential
