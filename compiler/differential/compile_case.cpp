#include "differential/compile_case.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <regex>

#include "differential/child.h"
#include "differential/steering.h"
#include "tool/compile.h"

namespace hlsc::differential {
namespace {

namespace fs = std::filesystem;

constexpr int kSeconds = 30;

/// `file:3:12: error: sentence` -> `3:12: sentence`, of several lines the first with an error; the case's own
/// directory is left out.
std::string bare_message(std::string text, const fs::path& kernel) {
  // The compiler names a file as it was given or relative to where it runs.
  const std::string name = kernel.filename().string();
  for (std::size_t at; (at = text.find("/" + name)) != std::string::npos;) {
    const std::size_t path =
        text.find_last_of(" (\n", at) + 1;  // npos + 1 is 0: the text begins with the path.
    text.erase(path, at + 1 - path);
  }
  static const std::regex kForm("(?:[^:\n]*:(\\d+:(?:\\d+:)? ))?(?:fatal )?(?:error|warning): ([^\n]*)");
  std::smatch match;
  if (!std::regex_search(text, match, kForm)) return text.substr(0, text.find('\n'));
  return match[1].str() + match[2].str();
}

void silence(const fs::path& log) {
  int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  dup2(file, 2);
  close(file);
}

int compile_into(const fs::path& kernel, const fs::path& work, bool strict) {
  silence(work / "compile.log");
  std::ofstream messages(work / "messages");
  try {
    Steering steering = read_steering(kernel);
    CompileOptions options;
    options.frontend.files = {kernel.string()};
    options.frontend.top = steering.top.empty() ? kernel.stem().string() : steering.top;
    options.strict = strict;
    CompileResult result = compile(options);
    for (const GeneratedFile& file : result.files) std::ofstream(work / file.name) << file.text;
    for (const std::string& warning : result.diagnostics.warnings)
      messages << bare_message(warning, kernel) << "\n";
    return static_cast<int>(Outcome::kPass);
  } catch (const std::exception& refusal) {
    messages << bare_message(refusal.what(), kernel) << "\n";
    return static_cast<int>(Outcome::kRefused);
  }
}

std::string joined(const std::vector<Statement>& statements) {
  std::string text;
  for (const Statement& statement : statements) text += statement.text + "\n";
  return text;
}

CaseResult compared(const CompileCheck& check, Outcome wanted_outcome, const std::string& wanted) {
  if (check.outcome == wanted_outcome && check.messages == wanted) return {};
  if (check.outcome != wanted_outcome && check.outcome != Outcome::kPass &&
      check.outcome != Outcome::kRefused)
    return {check.outcome, ""};
  return {Outcome::kExpectation, fmt::format("{}: {}", name_of(check.outcome), check.messages)};
}

}  // namespace

CompileCheck compile_case(const fs::path& kernel, const fs::path& work, bool strict) {
  ChildResult child = run_child([&] { return compile_into(kernel, work, strict); }, kSeconds);
  if (child.kind == ChildResult::kTimeout) return {Outcome::kHang, ""};
  if (child.kind == ChildResult::kSignal) return {Outcome::kCrash, fmt::format("signal {}", child.code)};
  return {static_cast<Outcome>(child.code), read_text(work / "messages")};
}

CaseResult check_messages(const fs::path& kernel, const fs::path& work) {
  Steering steering = read_steering(kernel);
  if (steering.warnings.empty())
    return compared(compile_case(kernel, work, false), Outcome::kRefused, joined(steering.errors));
  CaseResult lenient = compared(compile_case(kernel, work, false), Outcome::kPass, joined(steering.warnings));
  if (lenient.outcome != Outcome::kPass) return lenient;
  return compared(compile_case(kernel, work, true), Outcome::kRefused, steering.warnings[0].text + "\n");
}

}  // namespace hlsc::differential
