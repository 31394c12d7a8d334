#include "output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "host/atomic_file.h"
#include "host/error.h"

namespace floorline::app {

namespace fs = std::filesystem;

namespace {

/// Prints a line; throws Error when it did not arrive, for example in a file on a full disk.
void print_line(std::FILE* stream, const std::string& line) {
  fmt::print(stream, "{}\n", line);
  if (std::fflush(stream) != 0)
    throw Error(fmt::format("the results cannot be printed: {}.", std::strerror(errno)));
}

void create_parent(const fs::path& path) {
  std::error_code error;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  if (error)
    throw Error(
        fmt::format("the folder {} cannot be created: {}.", path.parent_path().string(), error.message()));
}

}  // namespace

void Output::add_option(CLI::App& parser) {
  parser
      .add_option("--json", json_target_,
                  "Also write the results as JSON to FILE ('-': to stdout, and the text to stderr)")
      ->type_name("FILE");
}

void Output::text(const std::string& line) const {
  std::FILE* stream = json_target_ == "-" ? stderr : stdout;
  print_line(stream, line);
}

void Output::json(const nlohmann::json& facts) const {
  if (json_target_.empty()) return;
  if (json_target_ == "-")
    print_line(stdout, facts.dump(2));
  else
    produce_file(json_target_, facts.dump(2) + "\n");
}

void produce_folder(const fs::path& destination, bool replace,
                    const std::function<void(const fs::path&)>& build) {
  const fs::path target =
      destination.has_filename() ? destination : destination.parent_path();  // a trailing slash
  create_parent(target);
  if (!fs::exists(target)) return build(target);
  if (!replace) {
    throw Error(fmt::format("{} is there already; choose another --output, or give --force to replace it.",
                            target.string()));
  }
  const fs::path fresh =
      target.parent_path() / fmt::format(".{}.{}.new", target.filename().string(), getpid());
  build(fresh);
  std::error_code error;
  fs::remove_all(target, error);
  if (!error) fs::rename(fresh, target, error);
  if (error) throw Error(fmt::format("{} cannot be replaced: {}.", target.string(), error.message()));
}

void produce_file(const fs::path& file, std::string_view content) {
  create_parent(file);
  write_file(file, content);
}

}  // namespace floorline::app
