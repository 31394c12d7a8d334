/// Runs the board demonstration on frames.grey and writes how often each bit changed to coverage.dat, after the first frame, which has no
/// reference yet. Prints the number of clock cycles that were counted.
#include <verilated.h>
#include <verilated_cov.h>

#include <cstdio>

#include "Vdemonstration.h"

namespace {

constexpr int kFrames = 2;  // of which the first one is not counted

void tick(Vdemonstration& model) {
  model.clk = 0;
  model.eval();
  model.clk = 1;
  model.eval();
}

}  // namespace

int main() {
  VerilatedContext context;
  Vdemonstration model(&context);
  model.rst = 1;
  for (int cycle = 0; cycle < 8; ++cycle) tick(model);
  model.rst = 0;
  long counted = 0;
  for (int frames = 0; frames < kFrames;) {
    const bool light = model.frame_light;
    tick(model);
    ++counted;
    if (model.frame_light == light) continue;
    if (++frames == 1) {
      context.coveragep()->zero();
      counted = 0;
    }
  }
  context.coveragep()->forcePerInstance(true);  // else the instances of a module are summed up
  context.coveragep()->write("coverage.dat");
  std::printf("%ld\n", counted);
  return 0;
}
