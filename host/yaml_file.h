/// YAML files whose every fault is one sentence that names the file.
#ifndef FLOORLINE_HOST_YAML_FILE_H
#define FLOORLINE_HOST_YAML_FILE_H

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <string>
#include <vector>

#include "host/error.h"

namespace floorline {

class YamlFile {
 public:
  /// Reads a mapping; the first line of OpenCV's dialect (%YAML:1.0) is accepted.
  explicit YamlFile(const std::filesystem::path& file);

  bool has(const std::string& key) const { return root_[key].IsDefined(); }

  template <typename Value>
  Value get(const std::string& key) const {
    try {
      return node(key).as<Value>();
    } catch (const YAML::Exception&) {
      refuse(fmt::format("'{}' has a value of the wrong kind", key));
    }
  }

  /// Finite numbers: a list, or the `data` of a matrix in OpenCV's or ROS's form.
  std::vector<double> numbers(const std::string& key) const;

  /// Throws Error: the file's name, `fault`, and what to do.
  [[noreturn]] void refuse(const std::string& fault) const;

 private:
  YAML::Node node(const std::string& key) const;

  std::filesystem::path file_;
  YAML::Node root_;
};

}  // namespace floorline

#endif
