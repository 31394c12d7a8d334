#include "frontend/directive.h"

#include <algorithm>
#include <sstream>

namespace hlsc {
namespace {

std::string folded(std::string text, int (*fold)(int)) {
  std::transform(text.begin(), text.end(), text.begin(), [fold](unsigned char c) { return fold(c); });
  return text;
}

}  // namespace

std::string Directive::text(const std::string& key, const std::string& otherwise) const {
  auto found = options.find(key);
  return found == options.end() ? otherwise : found->second;
}

long Directive::integer(const std::string& key, long otherwise) const {
  auto found = options.find(key);
  return found == options.end() ? otherwise : std::stol(found->second, nullptr, 0);
}

Directive parse_directive(const std::string& text) {
  std::istringstream words(text);
  Directive directive;
  words >> directive.kind;
  directive.kind = folded(directive.kind, ::toupper);
  for (std::string word; words >> word;) {
    size_t equals = word.find('=');
    std::string key = folded(word.substr(0, equals), ::tolower);
    directive.options[key] = equals == std::string::npos ? "" : word.substr(equals + 1);
  }
  return directive;
}

std::string to_text(const Directive& directive) {
  std::string text = directive.kind;
  for (const auto& [key, value] : directive.options) text += " " + key + (value.empty() ? "" : "=" + value);
  return text;
}

}  // namespace hlsc
