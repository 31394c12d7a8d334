#include "Vfloorline_top.h"
#include "Vfloorline_top_wide.h"
#include "tb/cosim/verilated_top.h"

namespace floorline::cosim {

std::unique_ptr<TopModel> make_model(Configuration configuration, std::uint64_t seed) {
  if (configuration == Configuration::vga) return std::make_unique<VerilatedTop<Vfloorline_top>>(seed);
  return std::make_unique<VerilatedTop<Vfloorline_top_wide>>(seed);
}

}  // namespace floorline::cosim
