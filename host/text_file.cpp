#include "host/text_file.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>

#include "host/error.h"

namespace floorline {
namespace {

/// Far above every file of a drive; a device or a film given by mistake must not fill the memory.
constexpr std::size_t largest_file = std::size_t{256} << 20;

std::string_view trim(std::string_view text) {
  const auto blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

}  // namespace

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  // A folder opens like a file and fails when it is read.
  if (!in || std::filesystem::is_directory(file)) {
    throw Error(fmt::format("{}: cannot be read; check the name and the permissions.", file.string()));
  }
  std::string text;
  for (char block[1 << 16]; in.read(block, sizeof block), in.gcount() > 0;) {
    text.append(block, static_cast<std::size_t>(in.gcount()));
    if (text.size() > largest_file) {
      throw Error(
          fmt::format("{}: is larger than {} MiB; give the right file.", file.string(), largest_file >> 20));
    }
  }
  return text;
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  std::size_t start = 0;
  while (start <= line.size()) {
    const std::size_t end = separator == ' ' ? line.find_first_of(" \t", start) : line.find(separator, start);
    const std::string_view field = trim(line.substr(start, end - start));
    if (separator != ' ' || !field.empty()) fields.push_back(field);
    if (end == std::string_view::npos) break;
    start = end + 1;
  }
  return fields;
}

std::optional<double> finite_number(std::string_view text) {
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = fault == std::errc{} && end == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::vector<NumberRow> read_numbers(const std::filesystem::path& file, char separator, std::size_t columns,
                                    std::string_view header) {
  const std::string text = read_text(file);
  std::vector<NumberRow> rows;
  int line_number = 0;
  bool header_due = !header.empty();
  for (std::string_view line : split(text, '\n')) {
    ++line_number;
    if (header_due) {
      if (line != header) refuse_line(file, line_number, fmt::format("the header should be '{}'", header));
      header_due = false;
      continue;
    }
    if (line.empty() || line.front() == '#') continue;
    NumberRow row{line_number, {}};
    for (std::string_view field : split(line, separator)) {
      const std::optional<double> number = finite_number(field);
      if (!number) refuse_line(file, line_number, fmt::format("'{}' is no finite number", field));
      row.values.push_back(*number);
    }
    if (row.values.size() != columns) {
      refuse_line(file, line_number,
                  fmt::format("there are {} numbers instead of {}", row.values.size(), columns));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

void refuse_line(const std::filesystem::path& file, int line, const std::string& fault) {
  throw Error(fmt::format("{}:{}: {}; correct the line.", file.string(), line, fault));
}

}  // namespace floorline
