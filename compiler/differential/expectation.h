/// What a case states about its schedule, FileCheck-like:
///   for (...) {  // expect: loop II=1            the pipelined loop that begins on this line
///   for (...) {  // expect: loop II=2 depth=4    depth: cycles of one iteration
///   for (...) {  // expect: loop unrolled        no loop is left of it
///   int bins[8]; // expect: memory bins ram      or registers, rom, port; none: no memory is left of it
#pragma once

#include <string>

#include "differential/steering.h"
#include "tool/compile.h"

namespace hlsc::differential {

/// The first expectation that does not hold, and what is there instead; empty when all hold.
/// Throws std::runtime_error when one cannot be understood.
std::string failed_expectation(const CompileResult& compiled, const Steering& steering);

}  // namespace hlsc::differential
