#include "differential/minimiser.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "differential/run_case.h"
#include "differential/steering.h"
#include "differential/undefined.h"

namespace hlsc::differential {
namespace {

namespace fs = std::filesystem;

class Minimiser {
 public:
  Minimiser(const fs::path& kernel, const fs::path& work, std::uint64_t seed)
      : work_(work), seed_(seed), text_(read_text(kernel)), failure_(run(text_)) {
    if (failure_.outcome == Outcome::kPass)
      throw std::runtime_error("the program passes; there is nothing to make smaller.");
    if (failure_.outcome == Outcome::kMismatch && is_undefined(work_))
      throw std::runtime_error("C++ leaves undefined what the program does; its results prove nothing.");
  }

  std::string run_to_end() {
    for (std::size_t before = text_.size() + 1; text_.size() < before;) {
      before = text_.size();
      drop_lines();
      shrink_parentheses();
    }
    return text_;
  }

 private:
  CaseResult run(const std::string& text) const {
    fs::path kernel = work_ / "smaller.cpp";
    std::ofstream(kernel) << text;
    return run_case(kernel, work_, seed_);
  }

  /// Keeps `text` if it still fails in the same way. Of refusals only internal errors are failures; a result
  /// that differs is none where C++ leaves it undefined.
  bool keep(const std::string& text) {
    CaseResult result = run(text);
    bool is_same = result.outcome == failure_.outcome;
    if (is_same && failure_.outcome == Outcome::kRefused)
      is_same = (result.detail.find("internal") != std::string::npos) ==
                (failure_.detail.find("internal") != std::string::npos);
    if (is_same && failure_.outcome == Outcome::kMismatch) is_same = !is_undefined(work_);
    if (is_same) text_ = text;
    return is_same;
  }

  static std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line + "\n");
    return lines;
  }

  void drop_lines() {
    for (std::size_t count = lines_of(text_).size() / 2; count > 0; count /= 2)
      for (std::size_t first = 0; first < lines_of(text_).size();) {
        std::vector<std::string> lines = lines_of(text_);
        std::string shorter;
        for (std::size_t i = 0; i < lines.size(); ++i)
          if (i < first || i >= first + count || lines[i].rfind("// ", 0) == 0) shorter += lines[i];
        if (shorter == text_ || !keep(shorter)) first += count;
      }
  }

  /// Replaces what stands in parentheses by 0 or 1, from the outside in.
  void shrink_parentheses() {
    for (std::size_t open = text_.find('('); open != std::string::npos; open = text_.find('(', open + 1)) {
      std::size_t close = open + 1;
      for (int depth = 1; close < text_.size() && depth > 0; ++close)
        depth += (text_[close] == '(') - (text_[close] == ')');
      if (close - open <= 3 || text_.find('\n', open) < close) continue;
      for (const char* simple : {"(0)", "(1)"}) {
        std::string shorter = text_;
        if (keep(shorter.replace(open, close - open, simple))) break;
      }
    }
  }

  fs::path work_;
  std::uint64_t seed_;
  std::string text_;
  CaseResult failure_;
};

}  // namespace

std::string minimised(const fs::path& kernel, const fs::path& work, std::uint64_t seed) {
  return Minimiser(kernel, work, seed).run_to_end();
}

}  // namespace hlsc::differential
