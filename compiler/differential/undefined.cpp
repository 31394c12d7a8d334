#include "differential/undefined.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "differential/child.h"
#include "differential/steering.h"

namespace hlsc::differential {
namespace {

namespace fs = std::filesystem;

constexpr int kSeconds = 120;

/// Builds the program with variables that start as `start` and runs it in a directory of that name; whether
/// the sanitizer lets it pass.
bool runs_clean(const fs::path& work, const std::string& start) {
  const fs::path directory = work / start;
  fs::create_directories(directory);
  auto run = [&](const std::string& command, const char* log) {
    return run_command(fmt::format("cd '{}' && {}", directory.string(), command), (directory / log).string(),
                       kSeconds);
  };
  ChildResult built =
      run(fmt::format(DIFFERENTIAL_CHECKED_COMPILER " -ftrivial-auto-var-init={} ../native.cpp -o checked",
                      start),
          "build.log");
  if (built.kind != ChildResult::kExit || built.code != 0)
    throw std::runtime_error("cannot build with the sanitizer; see " + (directory / "build.log").string());
  ChildResult ran = run("./checked", "run.log");
  return ran.kind == ChildResult::kExit && ran.code == 0;
}

bool same_records(const fs::path& one, const fs::path& other) {
  for (const auto& entry : fs::directory_iterator(one)) {
    const std::string name = entry.path().filename().string();
    bool is_record = name.find('.') == std::string::npos && name != "checked";
    if (is_record && read_text(entry.path()) != read_text(other / name)) return false;
  }
  return true;
}

}  // namespace

bool is_undefined(const fs::path& work) {
  return !runs_clean(work, "zero") || !runs_clean(work, "pattern") ||
         !same_records(work / "zero", work / "pattern");
}

}  // namespace hlsc::differential
