#include "tool/project_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace hlsc {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) {
    word.erase(std::remove_if(word.begin(), word.end(),
                              [](char c) { return std::string("\"{}").find(c) != std::string::npos; }),
               word.end());
    if (!word.empty()) words.push_back(word);
  }
  return words;
}

std::string trimmed(const std::string& text) {
  size_t first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::ifstream opened(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw CompileError("cannot read " + path + "; check its name");
  return in;
}

/// "10", "10ns", "100MHz" or "0.1GHz" in ns.
double period_of(const std::string& text, const SourceLocation& where) {
  size_t end = 0;
  double number = 0;
  try {
    number = std::stod(text, &end);
  } catch (const std::exception&) {
  }
  std::string unit = trimmed(text.substr(end));
  if (number > 0 && (unit.empty() || unit == "ns")) return number;
  if (number > 0 && unit == "MHz") return 1000 / number;
  if (number > 0 && unit == "GHz") return 1 / number;
  throw CompileError(where, "'" + text + "' is no clock; write a period as 10ns or a rate as 100MHz");
}

/// The delay model nearest to a part; empty when none is near.
std::string target_of(const std::string& part) {
  if (part.rfind("xc6v", 0) == 0) return "xc6v";
  if (part.rfind("xc", 0) == 0) return "xc7";
  if (part.rfind("LFE5", 0) == 0 || part.rfind("lfe5", 0) == 0) return "ecp5";
  return "";
}

class ConfigReader {
 public:
  explicit ConfigReader(const std::string& path) : path_(path), base_(fs::path(path).parent_path()) {}

  ProjectFile run() {
    std::ifstream in = opened(path_);
    for (std::string line; std::getline(in, line);) {
      ++line_;
      line = trimmed(line);
      if (line.empty() || line[0] == '#' || line[0] == '[') continue;
      size_t equals = line.find('=');
      if (equals == std::string::npos) throw CompileError(place(), "this line has no '='; write key=value");
      take(trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)));
    }
    return project_;
  }

 private:
  SourceLocation place() const { return {path_, line_, 0}; }
  std::string inside(const std::string& path) const { return (base_ / path).lexically_normal().string(); }

  void take(const std::string& key, const std::string& value) {
    static const std::string kDirective = "syn.directive.";
    if (key == "syn.top")
      project_.top = value;
    else if (key == "syn.file")
      add_source(value);
    else if (key == "syn.cflags")
      add_flags(value);
    else if (key == "tb.file")
      project_.test_bench_files.push_back(inside(value));
    else if (key == "tb.cflags")
      for (std::string word : words_of(value)) project_.test_bench_flags.push_back(with_directory(word));
    else if (key == "clock")
      project_.period = period_of(value, place());
    else if (key == "part")
      project_.target = target_of(value);
    else if (key.rfind(kDirective, 0) == 0)
      project_.directives.push_back(
          placed_directive(key.substr(kDirective.size()), words_of(value), place()));
  }

  void add_source(const std::string& file) {
    if (is_source_file(file)) project_.files.push_back(inside(file));
  }

  std::string with_directory(const std::string& word) const {
    return word.rfind("-I", 0) == 0 && word.size() > 2 ? "-I" + inside(word.substr(2)) : word;
  }

  void add_flags(const std::string& flags) {
    for (const std::string& word : words_of(flags)) {
      if (word.rfind("-I", 0) == 0) project_.include_dirs.push_back(inside(word.substr(2)));
      if (word.rfind("-D", 0) == 0) project_.defines.push_back(word.substr(2));
      if (word.rfind("-std=", 0) == 0) project_.standard = word.substr(5);
    }
  }

  std::string path_;
  fs::path base_;
  unsigned line_ = 0;
  ProjectFile project_;
};

}  // namespace

bool is_source_file(const std::string& name) {
  static const std::set<std::string> kExtensions = {".c", ".cc", ".cpp", ".cxx", ".C"};
  return kExtensions.count(fs::path(name).extension().string()) != 0;
}

PlacedDirective placed_directive(const std::string& kind, const std::vector<std::string>& words,
                                 const SourceLocation& where) {
  static const std::set<std::string> kFlags = {"off",      "rewind",       "recursive",       "region",
                                               "register", "enable_flush", "skip_exit_check", "complete",
                                               "cyclic",   "block"};
  PlacedDirective placed;
  placed.location = where;
  placed.text = kind;
  std::vector<std::string> names;
  for (size_t i = 0; i < words.size(); ++i) {
    std::string word = words[i];
    bool is_dashed = word.size() > 1 && word[0] == '-' && !std::isdigit(static_cast<unsigned char>(word[1]));
    if (is_dashed) word = word.substr(1);
    if (word.find('=') != std::string::npos || kFlags.count(word))
      placed.text += " " + word;
    else if (is_dashed && i + 1 < words.size())
      placed.text += " " + word + "=" + words[++i];
    else
      names.push_back(word);
  }
  if (names.empty())
    throw CompileError(where, "the directive names no function; write function or function/label");
  size_t slash = names[0].find('/');
  placed.function = names[0].substr(0, slash);
  if (slash != std::string::npos) placed.label = names[0].substr(slash + 1);
  if (names.size() > 1) placed.variable = names[1];
  return placed;
}

ProjectFile read_config(const std::string& path) { return ConfigReader(path).run(); }

std::vector<PlacedDirective> read_tcl_directives(const std::string& path) {
  static const std::string kCommand = "set_directive_";
  std::vector<PlacedDirective> directives;
  std::ifstream in = opened(path);
  unsigned number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::vector<std::string> words = words_of(line);
    if (words.empty() || words[0].rfind(kCommand, 0) != 0) continue;
    directives.push_back(placed_directive(words[0].substr(kCommand.size()), {words.begin() + 1, words.end()},
                                          {path, number, 0}));
  }
  return directives;
}

}  // namespace hlsc
