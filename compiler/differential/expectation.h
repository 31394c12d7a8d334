/// What a case states about its schedule (compiler/test/corpus/README.md), compared with the report.
#pragma once

#include <string>

#include "differential/steering.h"
#include "report/report.h"

namespace hlsc::differential {

/// The first expectation that does not hold, and what is there instead; empty when all hold.
/// Throws std::runtime_error when one cannot be understood.
std::string failed_expectation(const Report& report, const Steering& steering);

}  // namespace hlsc::differential
