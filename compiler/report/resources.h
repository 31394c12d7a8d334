/// Estimates of what a module takes on an FPGA, by operator and width. Synthesis has the last word.
#ifndef HLSC_REPORT_RESOURCES_H
#define HLSC_REPORT_RESOURCES_H

#include "design/design.h"
#include "schedule/schedule_process.h"

namespace hlsc {

struct Resources {
  int lut = 0, ff = 0, dsp = 0;
  int bram = 0;  ///< Blocks of 18 Kbit.

  Resources& operator+=(const Resources& other);
};

/// Logic by operator, flip-flops by the cycles over which a value is kept, multiplier blocks by the target's
/// operand widths, memory by size: small ones as LUT RAM, others as block RAM.
Resources estimate(const Process& process, const ProcessSchedule& schedule, const Target& target);

}  // namespace hlsc

#endif
