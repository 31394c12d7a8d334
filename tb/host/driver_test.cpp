#include "host/driver.h"

#include <map>

#include "host/text_file.h"
#include "rtl/floorline_registers.h"
#include "test_files.h"

namespace floorline {
namespace {

/// A core for frames of 640x480 and 256 lines that remembers what is written.
class FakeCore : public RegisterBus {
 public:
  std::uint32_t read32(std::uint32_t offset) override { return registers[offset]; }
  void write32(std::uint32_t offset, std::uint32_t value) override {
    registers[offset] = value;
    ++writes[offset];
  }

  std::map<std::uint32_t, std::uint32_t> registers = {
      {FLOORLINE_ID, FLOORLINE_ID_VALUE},
      {FLOORLINE_VERSION, FLOORLINE_VERSION_VALUE},
      {FLOORLINE_LIMITS, 640u << FLOORLINE_LIMITS_MAX_WIDTH_SHIFT |
                             480u << FLOORLINE_LIMITS_MAX_HEIGHT_SHIFT |
                             8u << FLOORLINE_LIMITS_LOG2_LINES_SHIFT}};
  std::map<std::uint32_t, int> writes;
};

FrameParameters vga_parameters() {
  FrameParameters parameters = {};
  parameters.width = 640;
  parameters.height = 480;
  parameters.homography.xv = -5;
  parameters.rule.horizon_row = -3;
  return parameters;
}

TEST(Driver, KnowsWhatTheCoreHolds) {
  FakeCore core;
  const Driver driver(core);
  EXPECT_EQ(driver.largest_frame(), cv::Size(640, 480));
  EXPECT_EQ(driver.most_lines(), 256u);
}

TEST(Driver, RefusesAnotherCoreAndAnotherMajorVersion) {
  for (const std::uint32_t offset : {FLOORLINE_ID, FLOORLINE_VERSION}) {
    FakeCore core;
    core.registers[offset] += 1u << 16;
    EXPECT_REFUSED(Driver{core}, "No Floorline core of version");
  }
}

TEST(Driver, WritesParametersAndLinesAndAsksForBoth) {
  FakeCore core;
  Driver driver(core);
  std::vector<LineSetup> lines(2);
  driver.prepare(vga_parameters(), lines);
  EXPECT_EQ(core.registers[FLOORLINE_WIDTH], 640u);
  EXPECT_EQ(core.registers[FLOORLINE_HEIGHT], 480u);
  EXPECT_EQ(core.registers[FLOORLINE_LINE_COUNT], 2u) << "comes from the lines";
  EXPECT_EQ(core.registers[FLOORLINE_HOMOGRAPHY_XU + 4], 0xfffffffbu);
  EXPECT_EQ(core.registers[FLOORLINE_RULE_HORIZON_ROW], 0x1ffdu) << "13 bits";
  EXPECT_EQ(core.writes[FLOORLINE_LINES], 1);
  EXPECT_EQ(core.writes[FLOORLINE_LINES + FLOORLINE_LINE_BYTES], 1);
  EXPECT_EQ(core.registers[FLOORLINE_UPDATE], FLOORLINE_UPDATE_PARAMETERS_MASK | FLOORLINE_UPDATE_LINES_MASK);
}

TEST(Driver, WritesOnlyWhatDiffersFromTheFrameBefore) {
  FakeCore core;
  Driver driver(core);
  FrameParameters parameters = vga_parameters();
  std::vector<LineSetup> lines(2);
  driver.prepare(parameters, lines);
  parameters.grey = 1;
  driver.prepare(parameters, lines);
  EXPECT_EQ(core.writes[FLOORLINE_GREY], 2);
  EXPECT_EQ(core.writes[FLOORLINE_WIDTH], 1);
  EXPECT_EQ(core.writes[FLOORLINE_LINES], 1);
  EXPECT_EQ(core.registers[FLOORLINE_UPDATE], FLOORLINE_UPDATE_PARAMETERS_MASK);
  lines[1].first_row = 7;
  driver.prepare(parameters, lines);
  EXPECT_EQ(core.writes[FLOORLINE_LINES], 2);
  EXPECT_EQ(core.registers[FLOORLINE_UPDATE], FLOORLINE_UPDATE_PARAMETERS_MASK | FLOORLINE_UPDATE_LINES_MASK);
}

TEST(Driver, RefusesWhatTheCoreCannotHold) {
  FakeCore core;
  Driver driver(core);
  FrameParameters wide = vga_parameters();
  wide.width = 641;
  EXPECT_REFUSED(driver.prepare(wide, {}), "A frame of 641x480 does not fit the core, which holds 640x480");
  EXPECT_REFUSED(driver.prepare(vga_parameters(), std::vector<LineSetup>(257)), "use at most 256");
  EXPECT_TRUE(core.writes.empty());
}

TEST(Driver, EnablesWaitsAndTakesEvents) {
  FakeCore core;
  Driver driver(core);
  driver.enable(true);
  EXPECT_EQ(core.registers[FLOORLINE_CONTROL], FLOORLINE_CONTROL_ENABLE_MASK);
  driver.enable(false);
  EXPECT_EQ(core.registers[FLOORLINE_CONTROL], 0u);
  EXPECT_TRUE(driver.prepared_frame_started());
  driver.prepare(vga_parameters(), {});
  EXPECT_FALSE(driver.prepared_frame_started());
  driver.interrupt_on(3);
  EXPECT_EQ(core.registers[FLOORLINE_INTERRUPT_ENABLE], 3u);
  core.registers[FLOORLINE_INTERRUPT_STATUS] = 5;
  EXPECT_EQ(driver.take_events(), 5u);
  EXPECT_EQ(core.writes[FLOORLINE_INTERRUPT_STATUS], 1) << "writing the events clears them";
}

TEST(Driver, ReadsEveryCounter) {
  FakeCore core;
  for (std::uint32_t offset = FLOORLINE_FRAMES; offset <= FLOORLINE_THRESHOLD_USED; offset += 4)
    core.registers[offset] = offset;
  Driver driver(core);
  const HardwareCounters counters = driver.counters();
  EXPECT_EQ(counters.frames, FLOORLINE_FRAMES);
  EXPECT_EQ(counters.malformed_frames, FLOORLINE_MALFORMED_FRAMES);
  EXPECT_EQ(counters.dropped_frames, FLOORLINE_DROPPED_FRAMES);
  EXPECT_EQ(counters.frame_cycles, FLOORLINE_FRAME_CYCLES);
  EXPECT_EQ(counters.input_stalls, FLOORLINE_INPUT_STALLS);
  EXPECT_EQ(counters.output_stalls, FLOORLINE_OUTPUT_STALLS);
  EXPECT_EQ(counters.first_result_latency, FLOORLINE_FIRST_RESULT_LATENCY);
  EXPECT_EQ(counters.decision_latency, FLOORLINE_DECISION_LATENCY);
  EXPECT_EQ(counters.null_pixels, FLOORLINE_NULL_PIXELS);
  EXPECT_EQ(counters.threshold_used, FLOORLINE_THRESHOLD_USED);
}

TEST(UioBus, MapsTheDevice) {
  const TemporaryFolder folder;
  const std::string device = (folder / "uio0").string();
  write_text(device, std::string(0x2000, '\0'));
  {
    UioBus bus(device);
    bus.write32(FLOORLINE_WIDTH, 0x44434241);
    EXPECT_EQ(bus.read32(FLOORLINE_WIDTH), 0x44434241u);
  }
  EXPECT_EQ(read_text(device).substr(FLOORLINE_WIDTH, 4), "ABCD");
  EXPECT_REFUSED(UioBus{(folder / "none").string()}, "none (No such file or directory): bind the core");
}

}  // namespace
}  // namespace floorline
