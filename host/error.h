/// The one error that people see: a sentence that says what is wrong and what to do.
#ifndef FLOORLINE_HOST_ERROR_H
#define FLOORLINE_HOST_ERROR_H

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace floorline {

class Error : public std::runtime_error {
 public:
  /// Quotes from files may hold anything: control characters become '?', so that the sentence stays whole and
  /// a terminal takes nothing for a command.
  explicit Error(std::string sentence) : std::runtime_error(printable(std::move(sentence))) {}

 private:
  static std::string printable(std::string text) {
    const auto control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
    std::ranges::replace_if(text, control, '?');
    return text;
  }
};

}  // namespace floorline

#endif
