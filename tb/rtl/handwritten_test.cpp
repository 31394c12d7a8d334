/// bench/handwritten, the yardstick of the compiler, must be worth comparing with: the same bits as the
/// kernels of hls/ under random stalls, and one element a clock without stalls.
#include <gtest/gtest.h>

#include <deque>
#include <memory>
#include <random>
#include <vector>

#include "Verode_handwritten.h"
#include "Vgaussian_handwritten.h"
#include "erode.h"
#include "gaussian.h"

namespace floorline {
namespace {

struct FrameRun {
  std::vector<unsigned> out;
  long cycles = 0;
};

/// One frame through a model with ap_ctrl_hs and one FIFO port on each side. stall: probability that a side
/// is not ready.
template <typename Model>
FrameRun run_frame(Model& model, const std::vector<unsigned>& in, unsigned seed, double stall) {
  std::mt19937 random(seed);
  std::bernoulli_distribution stalls(stall);
  std::deque<unsigned> waiting(in.begin(), in.end());
  FrameRun run;
  const long limit = 100 * static_cast<long>(in.size()) + 10000;
  model.ap_start = 1;
  for (bool done = false; !done && run.cycles < limit; ++run.cycles) {
    model.in_empty_n = !waiting.empty() && !stalls(random);
    model.in_dout = model.in_empty_n ? waiting.front() : 0;
    model.out_full_n = !stalls(random);
    model.clk = 0;
    model.eval();
    if (model.in_read && model.in_empty_n) waiting.pop_front();
    if (model.out_write && model.out_full_n) run.out.push_back(model.out_din);
    done = model.ap_done;
    if (model.ap_ready) model.ap_start = 0;
    model.clk = 1;
    model.eval();
  }
  EXPECT_LT(run.cycles, limit) << "hangs";
  EXPECT_TRUE(waiting.empty());
  return run;
}

template <typename Model>
void reset(Model& model) {
  model.ap_start = 0;
  model.rst = 1;
  for (int edge = 0; edge < 4; ++edge) {
    model.clk = edge & 1;
    model.eval();
  }
  model.rst = 0;
}

std::vector<unsigned> random_elements(size_t count, unsigned last, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<unsigned> element(0, last);
  std::vector<unsigned> elements(count);
  for (unsigned& value : elements) value = element(random);
  return elements;
}

template <typename Element, typename Kernel>
std::vector<unsigned> simulate(const std::vector<unsigned>& in, Kernel kernel) {
  hls::stream<Element> input("input"), output("output");
  for (unsigned value : in) input.write(value);
  kernel(input, output);
  std::vector<unsigned> out;
  while (!output.empty()) out.push_back(output.read().to_uint());
  return out;
}

struct Size2 {
  unsigned width, height;
};

class Handwritten : public testing::TestWithParam<Size2> {};

TEST_P(Handwritten, gaussian_gives_the_bits_of_the_kernel) {
  const auto [width, height] = GetParam();
  Vgaussian_handwritten model;
  reset(model);
  model.width = width;
  model.height = height;
  for (unsigned frame = 0; frame < 3; ++frame) {
    const std::vector<unsigned> in = random_elements(width * height, 255, frame);
    const auto expected = simulate<Pixel>(
        in, [&](auto& input, auto& output) { gaussian<640, 480>(input, output, width, height); });
    const FrameRun run = run_frame(model, in, frame, frame == 0 ? 0.0 : 0.3);
    EXPECT_EQ(run.out, expected);
    if (frame == 0) EXPECT_LE(run.cycles, width * height + width + 12);
  }
}

TEST_P(Handwritten, erode_gives_the_bits_of_the_kernel) {
  const auto [width, height] = GetParam();
  Verode_handwritten model;
  reset(model);
  model.width = width;
  model.height = height;
  for (unsigned frame = 0; frame < 6; ++frame) {
    // Mostly set, so that some neighbourhoods are whole.
    std::vector<unsigned> in = random_elements(width * height, 15, frame);
    for (unsigned& value : in) value = value < 13 ? 3 : value - 13;
    const ap_uint<1> erode_high = frame & 1;
    model.erode_high = frame & 1;
    const auto expected = simulate<Mask>(
        in, [&](auto& input, auto& output) { erode<640, 480>(input, output, width, height, erode_high); });
    const FrameRun run = run_frame(model, in, frame, frame < 2 ? 0.0 : 0.3);
    EXPECT_EQ(run.out, expected);
    if (frame < 2) EXPECT_LE(run.cycles, width * height + (erode_high ? width : 0) + 8);
  }
}

INSTANTIATE_TEST_SUITE_P(sizes, Handwritten,
                         testing::Values(Size2{16, 16}, Size2{17, 3}, Size2{64, 1}, Size2{5, 9},
                                         Size2{640, 8}),
                         [](const auto& info) {
                           return std::to_string(info.param.width) + "x" + std::to_string(info.param.height);
                         });

}  // namespace
}  // namespace floorline
