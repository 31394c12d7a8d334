/// bench/handwritten, the yardstick of the compiler, must be worth comparing with: the same bits as the
/// kernels of hls/ under random stalls, and one element a clock without stalls.
#include <gtest/gtest.h>

#include <deque>
#include <memory>
#include <random>
#include <vector>

#include "Verode_handwritten.h"
#include "Vgaussian_handwritten.h"
#include "Vhistogram_handwritten.h"
#include "Vpolar_handwritten.h"
#include "erode.h"
#include "gaussian.h"
#include "histogram.h"
#include "polar.h"

namespace floorline {
namespace {

struct FrameRun {
  std::vector<unsigned> out, counts;
  long cycles = 0;
};

/// One frame through a model with ap_ctrl_hs and one FIFO port on each side; the histogram has one more, for
/// its counts. stall: probability that a side is not ready.
template <typename Model>
FrameRun run_frame(Model& model, const std::vector<unsigned>& in, unsigned seed, double stall) {
  constexpr bool has_counts = requires { model.counts_din; };
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
    if constexpr (has_counts) model.counts_full_n = !stalls(random);
    model.clk = 0;
    model.eval();
    if (model.in_read && model.in_empty_n) waiting.pop_front();
    if (model.out_write && model.out_full_n) run.out.push_back(model.out_din);
    if constexpr (has_counts) {
      if (model.counts_write && model.counts_full_n) run.counts.push_back(model.counts_din);
    }
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

TEST_P(Handwritten, histogram_gives_the_bits_of_the_kernel) {
  const auto [width, height] = GetParam();
  Vhistogram_handwritten model;
  reset(model);
  model.width = width;
  model.height = height;
  for (unsigned frame = 0; frame < 4; ++frame) {
    // Few levels, so that many come again within two pixels.
    const std::vector<unsigned> in = random_elements(width * height, frame < 2 ? 3 : 255, frame);
    hls::stream<Pixel> input("input"), output("output");
    HistogramTotals<640 * 480>::Count bins[LEVELS] = {};
    for (unsigned value : in) input.write(value);
    count_levels<640, 480>(input, output, bins, width, height);
    std::vector<unsigned> expected;
    for (const auto& bin : bins) expected.push_back(bin.to_uint());

    const FrameRun run = run_frame(model, in, frame, frame == 0 ? 0.0 : 0.3);
    EXPECT_EQ(run.out, in);
    EXPECT_EQ(run.counts, expected) << "frame " << frame;
    if (frame == 0) EXPECT_LE(run.cycles, width * height + 2 * LEVELS + 8);
  }
}

/// Bits of a stream element, fields packed from bit 0 in the order of the struct.
uint64_t pack(const Contact& contact) {
  uint64_t bits = contact.line.to_uint() | uint64_t(contact.u.to_int() & 0x1fff) << 8 |
                  uint64_t(contact.v.to_uint()) << 21;
  return bits | uint64_t(contact.rows.to_uint()) << 33 | uint64_t(contact.clipped.to_uint()) << 45 |
         uint64_t(contact.end.to_uint()) << 46;
}

uint64_t pack(const LineCount& count) {
  return count.line.to_uint() | uint64_t(count.count.to_uint()) << 8 | uint64_t(count.end.to_uint()) << 20;
}

constexpr int kMaxLines = 256;

/// A line that walks anywhere: steep or shallow, in or out of the image, its rows in order.
LineSetup random_line(std::mt19937& random, int width, int height) {
  auto between = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  LineSetup line = LineSetup();
  const int rows = between(1, height);
  line.first_row = between(0, height - 1);
  line.last_row = line.first_row + rows - 1;
  line.first_column = between(-8, width + 8);
  line.slice = between(0, 2) ? 0 : between(1, 5);
  line.first_run = line.slice == 0 ? 1 : between(1, 6);
  line.last_run = line.slice == 0 ? 1 : between(1, 6);
  line.divisor = rows;
  line.remainder = between(0, rows - 1);
  line.first_error = between(0, rows - 1);
  line.leftward = between(0, 1);
  line.contact_first = between(0, 1);
  return line;
}

void write_line(Vpolar_handwritten& model, const LineSetup& line) {
  const std::pair<unsigned, unsigned> fields[] = {{line.first_column.to_int() & 0x1fff, 13},
                                                  {line.first_row.to_uint(), 12},
                                                  {line.last_row.to_uint(), 12},
                                                  {line.first_run.to_uint(), 12},
                                                  {line.last_run.to_uint(), 12},
                                                  {line.slice.to_uint(), 12},
                                                  {line.remainder.to_uint(), 12},
                                                  {line.divisor.to_uint(), 12},
                                                  {line.first_error.to_uint(), 12},
                                                  {line.leftward.to_uint(), 1},
                                                  {line.contact_first.to_uint(), 1}};
  for (unsigned word = 0; word < 4; ++word) model.lines_q0[word] = 0;
  unsigned at = 0;
  for (const auto& [value, bits] : fields)
    for (unsigned bit = 0; bit < bits; ++bit, ++at)
      model.lines_q0[at / 32] |= (value >> bit & 1u) << (at % 32);
}

TEST_P(Handwritten, polar_gives_the_bits_of_the_kernel) {
  const auto [width, height] = GetParam();
  if (width < 16) GTEST_SKIP() << "the polar engine needs 16 columns";
  Vpolar_handwritten model;
  reset(model);
  model.width = width;
  model.height = height;
  size_t contacts_found = 0;
  for (unsigned frame = 0; frame < 12; ++frame) {
    std::mt19937 random(frame);
    auto between = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
    RuleParameters rule = RuleParameters();
    rule.run_rule = frame & 1;
    rule.min_rows = between(1, 3);
    rule.max_gap = between(0, 2);
    rule.horizon_row = between(-4, 4);
    rule.height_ratio = between(0, 200);
    const int line_count = frame == 0 ? 0 : between(1, std::min<int>(kMaxLines, width - 16 + 4));
    static LineSetup lines[kMaxLines];
    for (LineSetup& line : lines) line = random_line(random, width, height);
    std::vector<unsigned> in = random_elements(width * height, 9, frame);
    for (unsigned& value : in) value = value < 3 ? 0 : value < 5 ? 1 : 3;

    std::vector<unsigned> motion = random_elements(width * height, 16, frame + 100);
    for (unsigned& value : motion) value = value < 3 ? value + 1 : value % 2 ? RESTS : UNKNOWN;

    hls::stream<Mask> mask("mask");
    hls::stream<Motion> motions("motions");
    hls::stream<Contact> contacts("contacts");
    hls::stream<LineCount> counts("counts");
    for (unsigned value : in) mask.write(value);
    for (unsigned value : motion) motions.write(value);
    polar<640, 480, kMaxLines>(mask, motions, contacts, counts, width, height, line_count, rule, lines);
    std::vector<uint64_t> expected_contacts, expected_counts;
    while (!contacts.empty()) expected_contacts.push_back(pack(contacts.read()));
    while (!counts.empty()) expected_counts.push_back(pack(counts.read()));

    model.line_count = line_count;
    model.rule_run_rule = rule.run_rule.to_uint();
    model.rule_min_rows = rule.min_rows.to_uint();
    model.rule_max_gap = rule.max_gap.to_uint();
    model.rule_horizon_row = rule.horizon_row.to_int() & 0x1fff;
    model.rule_height_ratio = rule.height_ratio.to_uint();
    std::bernoulli_distribution stalls(frame < 2 ? 0.0 : 0.3);
    std::vector<uint64_t> seen_contacts, seen_counts;
    size_t taken = 0;
    long cycles = 0;
    model.ap_start = 1;
    for (bool done = false; !done && cycles < 100000; ++cycles) {
      model.mask_empty_n = taken < in.size() && !stalls(random);
      model.mask_dout = model.mask_empty_n ? in[taken] : 0;
      model.motions_empty_n = taken < in.size() && !stalls(random);
      model.motions_dout = model.motions_empty_n ? motion[taken] : 0;
      model.contacts_full_n = !stalls(random);
      model.counts_full_n = !stalls(random);
      model.clk = 0;
      model.eval();
      if (model.mask_read && model.mask_empty_n) ++taken;
      if (model.contacts_write && model.contacts_full_n) seen_contacts.push_back(model.contacts_din);
      if (model.counts_write && model.counts_full_n) seen_counts.push_back(model.counts_din);
      const bool asked = model.lines_ce0;
      const unsigned address = model.lines_address0;
      done = model.ap_done;
      if (done) model.ap_start = 0;
      model.clk = 1;
      model.eval();
      if (asked) write_line(model, lines[address]);
    }
    EXPECT_EQ(taken, in.size());
    EXPECT_EQ(seen_contacts, expected_contacts) << "frame " << frame;
    contacts_found += seen_contacts.size() - 1;
    EXPECT_EQ(seen_counts, expected_counts) << "frame " << frame;
    if (frame < 2) EXPECT_LE(cycles, width * height + line_count + 24);
  }
  if (height >= 8) EXPECT_GT(contacts_found, 0u) << "lower frames have no room for seven rows that stir";
}

INSTANTIATE_TEST_SUITE_P(sizes, Handwritten,
                         testing::Values(Size2{24, 16}, Size2{17, 3}, Size2{64, 1}, Size2{5, 9},
                                         Size2{640, 8}),
                         [](const auto& info) {
                           return std::to_string(info.param.width) + "x" + std::to_string(info.param.height);
                         });

}  // namespace
}  // namespace floorline
