/// Results of a command: text for people, JSON for scripts, files and folders that appear whole or not at
/// all.
#ifndef FLOORLINE_APPS_OUTPUT_H
#define FLOORLINE_APPS_OUTPUT_H

#include <CLI/App.hpp>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace floorline::app {

/// Text goes to stdout and, with --json FILE, the same facts to a file; --json - puts the JSON on stdout and
/// the text on stderr.
class Output {
 public:
  void add_option(CLI::App& parser);
  void text(const std::string& line) const;
  void json(const nlohmann::json& facts) const;

 private:
  std::string json_target_;
};

/// Calls build(folder) with the name of a folder that is not there yet and must be complete when it returns;
/// that folder then takes the place of `destination`. Throws Error when `destination` is there already and
/// `replace` is not set. Creates the folders above it.
void produce_folder(const std::filesystem::path& destination, bool replace,
                    const std::function<void(const std::filesystem::path&)>& build);

/// write_file() of host, after creating the folders above.
void produce_file(const std::filesystem::path& file, std::string_view content);

}  // namespace floorline::app

#endif
