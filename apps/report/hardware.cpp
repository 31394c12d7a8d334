#include "hardware.h"

#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>

#include "image_uri.h"

namespace floorline::report {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
  throw std::runtime_error(file.string() + ": " + what + " (docs/report.md shows the form).");
}

std::vector<unsigned char> read_bytes(const fs::path& picture, const fs::path& file) {
  std::ifstream in(picture, std::ios::binary);
  if (!in) fail(file, "the picture " + picture.string() + " cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string picture_uri(const json& picture, const fs::path& file) {
  static const std::map<std::string, std::string> media_types = {{".svg", "image/svg+xml"},
                                                                 {".png", "image/png"}};
  if (!picture.is_string()) fail(file, "\"picture\" must be the name of an SVG or PNG file");
  const fs::path path = file.parent_path() / picture.get<std::string>();
  const auto type = media_types.find(path.extension().string());
  if (type == media_types.end()) fail(file, "the picture " + path.string() + " is neither .svg nor .png");
  return data_uri(type->second, read_bytes(path, file));
}

void check_table(const json& section, const std::string& title, const fs::path& file) {
  const auto is_row = [](const json& row, std::size_t width) {
    return row.is_array() && row.size() == width && std::all_of(row.begin(), row.end(), [](const json& cell) {
             return cell.is_string() || cell.is_number();
           });
  };
  const json& columns = section.value("columns", json::array());
  if (!is_row(columns, columns.size()))
    fail(file, "\"columns\" of section '" + title + "' must be a list of texts");
  for (const json& row : section.value("rows", json::array())) {
    if (!is_row(row, columns.size()))
      fail(file, "each row of section '" + title + "' must hold a text or number for every column");
  }
}

json checked_section(json section, const fs::path& file) {
  if (!section.is_object() || !section.contains("title") || !section["title"].is_string())
    fail(file, "every section must be an object with a \"title\"");
  const std::string title = section["title"];
  check_table(section, title, file);
  if (section.contains("picture")) section["picture"] = picture_uri(section["picture"], file);
  return section;
}

}  // namespace

json read_hardware(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + ": the hardware file cannot be read.");
  const json content = json::parse(in, nullptr, false);
  if (!content.is_array()) fail(file, "the file is not a JSON list of sections");
  json sections = json::array();
  for (const json& section : content) sections.push_back(checked_section(section, file));
  return sections;
}

}  // namespace floorline::report
