/// Counters that only tell when they reach a bound count down to a constant instead.
#ifndef HLSC_DESIGN_COUNT_DOWN_H
#define HLSC_DESIGN_COUNT_DOWN_H

#include "design/design.h"

namespace hlsc {

/// Replaces a loop's counter u that starts at 0 and is only compared with X + C, X a scalar port, by X - u:
/// it is compared with the constant -C, and the bound needs no register. After narrow(); what computed the
/// bound is left behind, dead.
void count_down(Process& process);

}  // namespace hlsc

#endif
