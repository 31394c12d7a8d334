#include "tb/cosim/port_watch.h"

namespace floorline::cosim {

void PortWatch::see(const PortCycle& cycle) {
  if (passed()) {
    if (after_ == kAfter) return;
    ++after_;
  } else {
    if (cycles_.size() > kBefore) cycles_.pop_front();
    if (cycle.ports[index(port_)].moves()) --to_pass_;
  }
  cycles_.push_back(cycle);
}

}  // namespace floorline::cosim
