/// The native half of a case: a C++ program that calls the kernel with random arguments and records, port by
/// port of the compiled top, what goes in and what C++ says must come out.
#pragma once

#include <cstdint>
#include <string>

#include "differential/steering.h"
#include "tool/compile.h"

namespace hlsc::differential {

/// Words of a file for each port; the native program writes them into its working directory:
///   stream_I_hex            tokens;  stream_I_end: count of tokens after each call
///   memory_I_before, _after contents of all calls, one after the other
///   scalar_I_hex            one word a call: of an input its value, of an output its value after the call
///   scalar_I_before         one word a call: of an output its object's value before the call
/// where I is the index in the TopInterface.
std::string native_program(const CompileResult& compiled, const CompileOptions& options,
                           const Steering& steering, std::uint64_t seed);

/// Elements behind parameter `index` of the top: 1 for a scalar.
long element_count(const CompileResult& compiled, const Steering& steering, std::size_t index);

/// The bits of a scalar port that carry a value, as a hexadecimal mask.
std::string value_mask(const CompileResult& compiled, const ScalarPort& port);

}  // namespace hlsc::differential
