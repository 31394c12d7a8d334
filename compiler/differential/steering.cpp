#include "differential/steering.h"

#include <fmt/format.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace hlsc::differential {
namespace {

/// `name=low..high` or `name=count`.
void read_named(Steering& steering, const std::string& key, const std::string& value) {
  std::smatch match;
  if (key == "range" && std::regex_match(value, match, std::regex("(\\w+)=(-?\\d+)\\.\\.(-?\\d+)")))
    steering.ranges[match[1]] = {std::stoll(match[2]), std::stoll(match[3])};
  else if (key == "array" && std::regex_match(value, match, std::regex("(\\w+)=(\\d+)")))
    steering.elements[match[1]] = std::stol(match[2]);
  else
    throw std::runtime_error(
        fmt::format("cannot read `// {}: {}`; write range: n=1..16 or array: a=64.", key, value));
}

void read_option(Steering& steering, const std::string& key, const std::string& value) {
  if (key == "top") steering.top = value;
  if (key == "calls") steering.calls = std::stoi(value);
  if (key == "tokens") steering.tokens = std::stoi(value);
  if (key == "file") steering.files.push_back(value);
  if (key == "range" || key == "array") read_named(steering, key, value);
}

void read_statement(Steering& steering, const std::string& key, const Statement& statement) {
  (key == "expect"  ? steering.expectations
   : key == "error" ? steering.errors
                    : steering.warnings)
      .push_back(statement);
}

}  // namespace

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(fmt::format("cannot read {}; check the path.", path.string()));
  return {std::istreambuf_iterator<char>(file), {}};
}

Steering read_steering(const std::filesystem::path& kernel) {
  static const std::regex kOption("// (top|calls|tokens|file|range|array): *(.*?) *");
  static const std::regex kStatement("// (expect|error|warning): *(.*?) *$");
  Steering steering;
  std::istringstream lines(read_text(kernel));
  std::smatch match;
  unsigned number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (std::regex_match(line, match, kOption)) read_option(steering, match[1], match[2]);
    if (std::regex_search(line, match, kStatement)) read_statement(steering, match[1], {match[2], number});
  }
  return steering;
}

}  // namespace hlsc::differential
