/// A random test bench for any kernel: the kernel's own text without the body of its top, and a main() that
/// calls the top with random arguments and prints every result. Linked with the kernel it tells what C++
/// says; run by `floorline-hlsc cosim` it tells what the Verilog says; the two texts must be equal.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace hlsc::differential {

/// The comments at the head of a kernel that steer its test bench (compiler/test/corpus/README.md).
struct Steering {
  struct Range {
    long long low, high;
  };
  std::string top;
  int calls = 8;
  int tokens = 256;
  std::vector<std::pair<std::string, Range>> ranges;
};

/// Throws std::runtime_error when `kernel` has no `// top:` line or a line cannot be read.
Steering read_steering(const std::filesystem::path& kernel);

/// The test bench's C++ text. A stream whose name begins with `out` or `sink` is an output, any other an
/// input. Throws std::runtime_error when the kernel cannot be parsed or an argument's type is not one of the
/// subset.
std::string generate_testbench(const std::filesystem::path& kernel,
                               const std::vector<std::filesystem::path>& include_folders, std::uint64_t seed);

}  // namespace hlsc::differential
