#include "differential/mutator.h"

#include <random>
#include <regex>
#include <vector>

namespace hlsc::differential {
namespace {

/// Tokens with the white space before them; a pragma is one line of tokens as all else is.
std::vector<std::string> tokens_of(const std::string& program) {
  static const std::regex kToken("\\s*(?:\\w+|[^\\w\\s])");
  std::vector<std::string> tokens;
  for (std::sregex_iterator at(program.begin(), program.end(), kToken), end; at != end; ++at)
    tokens.push_back(at->str());
  return tokens;
}

}  // namespace

std::string mutated(const std::string& program, std::uint64_t seed) {
  static const char* const kReplacements[] = {" 0", " -1",  " 4294967296", " x",   " *",   " &",     " ;",
                                              " }", " 1.5", " while(1)",   " HLS", " int", " return"};
  std::mt19937_64 random(seed);
  std::vector<std::string> tokens = tokens_of(program);
  for (int changes = 1 + random() % 3; changes > 0 && tokens.size() > 1; --changes) {
    std::size_t a = random() % tokens.size(), b = random() % tokens.size();
    switch (random() % 4) {
      case 0:
        tokens.erase(tokens.begin() + static_cast<long>(a));
        break;
      case 1:
        tokens.insert(tokens.begin() + static_cast<long>(a), tokens[b]);
        break;
      case 2:
        std::swap(tokens[a], tokens[b]);
        break;
      default:
        tokens[a] = kReplacements[random() % std::size(kReplacements)];
    }
  }
  std::string text;
  for (const std::string& token : tokens) text += token;
  return text + "\n";
}

}  // namespace hlsc::differential
