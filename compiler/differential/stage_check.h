/// Checks each stage of the compiler by itself: its process is interpreted on the recorded inputs, and what
/// comes out must be what native execution recorded. A fault then has the name of the first stage that has
/// it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "differential/steering.h"
#include "tool/compile.h"

namespace hlsc::differential {

class StageCheck {
 public:
  /// Keeps a copy of the process at every stage; for CompileOptions::on_stage.
  StageObserver observer();

  /// The first stage whose process differs from the records in `work`, and how; empty when none does. A
  /// dataflow region, several processes side by side, and a loop without end are left to the Verilog.
  std::string wrong_stage(const CompileResult& compiled, const Steering& steering,
                          const std::filesystem::path& work) const;

 private:
  struct Stage {
    std::string name;
    Process process;
    ProcessSchedule schedule;
    bool is_scheduled = false;
  };
  std::vector<Stage> stages_;
};

}  // namespace hlsc::differential
