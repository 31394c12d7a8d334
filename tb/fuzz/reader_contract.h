/// What every reader promises, whatever the file holds: it loads, or it throws Error with a sentence.
/// Anything else (another exception, a crash, a sanitizer's report, a hang, much memory) is a finding of
/// libFuzzer.
#ifndef FLOORLINE_TB_FUZZ_READER_CONTRACT_H
#define FLOORLINE_TB_FUZZ_READER_CONTRACT_H

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "host/error.h"

namespace floorline::fuzz {

[[noreturn]] inline void finding(const std::string& what) {
  std::fprintf(stderr, "finding: %s\n", what.c_str());
  std::abort();
}

/// The input as a file in memory, since the readers take paths; one after the other under the same path.
class InputFile {
 public:
  void fill(const std::uint8_t* data, std::size_t size) const {
    if (ftruncate(descriptor_, 0) != 0 || pwrite(descriptor_, data, size, 0) != static_cast<ssize_t>(size))
      finding("no memory for the input");
  }
  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_ = memfd_create("input", 0);
};

/// Runs `read`, which calls a reader.
template <typename Read>
void load_or_refuse(Read read) {
  try {
    read();
  } catch (const Error& error) {
    if (!std::string_view(error.what()).ends_with('.')) finding(std::string("no sentence: ") + error.what());
  }
}

}  // namespace floorline::fuzz

#endif
