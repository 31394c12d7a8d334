/// Makes a failing program small: deletes lines and replaces expressions while it fails in the same way.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace hlsc::differential {

/// The smallest program found that ends as `kernel` does when run with `seed`. `work` exists and is
/// overwritten. Throws std::runtime_error when `kernel` passes.
std::string minimised(const std::filesystem::path& kernel, const std::filesystem::path& work,
                      std::uint64_t seed);

}  // namespace hlsc::differential
