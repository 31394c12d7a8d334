/// Broken input: a program with a few tokens deleted, doubled, swapped or replaced.
#pragma once

#include <cstdint>
#include <string>

namespace hlsc::differential {

std::string mutated(const std::string& program, std::uint64_t seed);

}  // namespace hlsc::differential
