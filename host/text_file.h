/// Text files of numbers: whole files, and tables line by line.
#ifndef FLOORLINE_HOST_TEXT_FILE_H
#define FLOORLINE_HOST_TEXT_FILE_H

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace floorline {

/// The whole file. Throws Error when it cannot be read or is larger than any file of a drive.
std::string read_text(const std::filesystem::path& file);

/// Fields of a line, cut at `separator`; a space also stands for several of them and for tabs.
std::vector<std::string_view> split(std::string_view line, char separator);

/// The finite number that `text` is, if it is one and nothing more.
std::optional<double> finite_number(std::string_view text);

/// A row of a table of numbers with its place in the file, for messages.
struct NumberRow {
  int line;
  std::vector<double> values;
};

/// A table of finite numbers, `columns` a row. Blank lines and lines that start with # are skipped. `header`:
/// the first line, when the format has one. Throws Error naming file and line when something else is found.
std::vector<NumberRow> read_numbers(const std::filesystem::path& file, char separator, std::size_t columns,
                                    std::string_view header = {});

/// Throws Error: file, line, `fault`, and what to do.
[[noreturn]] void refuse_line(const std::filesystem::path& file, int line, const std::string& fault);

}  // namespace floorline

#endif
