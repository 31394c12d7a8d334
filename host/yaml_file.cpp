#include "host/yaml_file.h"

#include <cmath>

#include "host/text_file.h"

namespace floorline {

YamlFile::YamlFile(const std::filesystem::path& file) : file_(file) {
  std::string text = read_text(file);
  // yaml-cpp takes the colon for a fault.
  if (text.starts_with("%YAML:")) text.erase(0, text.find('\n'));
  try {
    root_ = YAML::Load(text);
  } catch (const YAML::Exception& fault) {
    refuse(fmt::format("line {} is no YAML", fault.mark.line + 1));
  }
  if (!root_.IsMap()) refuse("there are no keys");
}

YAML::Node YamlFile::node(const std::string& key) const {
  if (!has(key)) refuse(fmt::format("'{}' is missing", key));
  return root_[key];
}

std::vector<double> YamlFile::numbers(const std::string& key) const {
  const YAML::Node value = node(key);
  try {
    const auto numbers = (value.IsMap() ? value["data"] : value).as<std::vector<double>>();
    for (const double number : numbers) {
      if (!std::isfinite(number)) refuse(fmt::format("'{}' holds a number that is not finite", key));
    }
    return numbers;
  } catch (const YAML::Exception&) {
    refuse(fmt::format("'{}' is no list of numbers", key));
  }
}

void YamlFile::refuse(const std::string& fault) const {
  throw Error(fmt::format("{}: {}; correct the file.", file_.string(), fault));
}

}  // namespace floorline
