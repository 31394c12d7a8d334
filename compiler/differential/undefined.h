/// Undefined behaviour of a case's program: what it does then proves nothing about the compiler.
#pragma once

#include <filesystem>

namespace hlsc::differential {

/// Whether the native program that run_case left in `work` does what C++ leaves undefined: what Clang's
/// undefined-behaviour sanitizer finds (signed overflow wraps and is allowed), or results that change with the
/// initial value of variables that have none. Throws std::runtime_error when it cannot be built.
bool is_undefined(const std::filesystem::path& work);

}  // namespace hlsc::differential
