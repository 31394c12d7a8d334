#include "host/driver.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "host/error.h"
#include "host/packing.h"
#include "rtl/floorline_registers.h"

namespace floorline {
namespace {

constexpr std::size_t kMapBytes = 0x2000;

std::uint32_t field(std::uint32_t value, std::uint32_t mask, int shift) { return (value & mask) >> shift; }

/// The parameter registers in the order of the map, which is that of the struct.
std::array<std::uint32_t, FLOORLINE_PARAMETER_COUNT> register_values(const FrameParameters& p) {
  const auto signed_bits = [](const auto& value, std::uint32_t mask) {
    return static_cast<std::uint32_t>(value.to_int()) & mask;
  };
  constexpr std::uint32_t kWord = 0xffffffff;
  std::array<std::uint32_t, FLOORLINE_PARAMETER_COUNT> values = {};
  const auto at = [&](std::uint32_t offset) -> std::uint32_t& {
    return values[(offset - FLOORLINE_WIDTH) / 4];
  };
  at(FLOORLINE_WIDTH) = p.width.to_uint();
  at(FLOORLINE_HEIGHT) = p.height.to_uint();
  at(FLOORLINE_GREY) = p.grey.to_uint();
  at(FLOORLINE_REPLACE_REFERENCE) = p.replace_reference.to_uint();
  at(FLOORLINE_ERODE_HIGH) = p.erode_high.to_uint();
  at(FLOORLINE_ROI_FIRST_ROW) = p.roi_first_row.to_uint();
  at(FLOORLINE_ROI_LAST_ROW) = p.roi_last_row.to_uint();
  at(FLOORLINE_LINE_COUNT) = p.line_count.to_uint();
  at(FLOORLINE_CLUSTER_GAP) = p.cluster_gap.to_uint();
  const auto map = [&](std::uint32_t offset, const ProjectiveMap& m) {
    for (const ap_int<32>* value : {&m.xu, &m.xv, &m.x1, &m.yu, &m.yv, &m.y1, &m.zu, &m.zv, &m.z1}) {
      at(offset) = signed_bits(*value, kWord);
      offset += 4;
    }
  };
  map(FLOORLINE_HOMOGRAPHY_XU, p.homography);
  map(FLOORLINE_BIRDSEYE_XU, p.birdseye);
  at(FLOORLINE_THRESHOLD_FLOOR) = p.threshold.floor.to_uint();
  at(FLOORLINE_THRESHOLD_OVERRIDE_HIGH) = p.threshold.override_high.to_uint();
  at(FLOORLINE_THRESHOLD_LOW) = p.threshold.low.to_uint();
  at(FLOORLINE_DISPLACEMENT_NOISE) = p.displacement.noise.to_uint();
  at(FLOORLINE_DISPLACEMENT_BOUND) = signed_bits(p.displacement.bound, 0xffffff);
  at(FLOORLINE_DISPLACEMENT_BOUND_STEP) = signed_bits(p.displacement.bound_step, 0xffffff);
  at(FLOORLINE_RULE_RUN_RULE) = p.rule.run_rule.to_uint();
  at(FLOORLINE_RULE_MIN_ROWS) = p.rule.min_rows.to_uint();
  at(FLOORLINE_RULE_MAX_GAP) = p.rule.max_gap.to_uint();
  at(FLOORLINE_RULE_HORIZON_ROW) = signed_bits(p.rule.horizon_row, 0x1fff);
  at(FLOORLINE_RULE_HEIGHT_RATIO) = p.rule.height_ratio.to_uint();
  at(FLOORLINE_RULE_MIN_LINES) = p.rule.min_lines.to_uint();
  return values;
}

bool same(const std::vector<LineSetup>& a, const std::vector<LineSetup>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (pack(a[i]) != pack(b[i])) return false;
  }
  return true;
}

}  // namespace

UioBus::UioBus(const std::string& device) {
  const int file = open(device.c_str(), O_RDWR | O_SYNC);
  void* map = file < 0 ? MAP_FAILED : mmap(nullptr, kMapBytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  const int reason = errno;
  if (file >= 0) close(file);
  if (map == MAP_FAILED) {
    throw Error(fmt::format("Cannot map {} ({}): bind the core to uio_pdrv_genirq and check the permissions.",
                            device, std::strerror(reason)));
  }
  registers_ = static_cast<volatile std::uint32_t*>(map);
}

UioBus::~UioBus() { munmap(const_cast<std::uint32_t*>(registers_), kMapBytes); }

std::uint32_t UioBus::read32(std::uint32_t offset) { return registers_[offset / 4]; }

void UioBus::write32(std::uint32_t offset, std::uint32_t value) { registers_[offset / 4] = value; }

Driver::Driver(RegisterBus& bus) : bus_(bus) {
  const std::uint32_t id = bus_.read32(FLOORLINE_ID);
  const std::uint32_t version = bus_.read32(FLOORLINE_VERSION);
  if (id != FLOORLINE_ID_VALUE || version >> 16 != FLOORLINE_VERSION_VALUE >> 16) {
    throw Error(
        fmt::format("No Floorline core of version {}.x answers (ID {:#010x}, VERSION {:#010x}): check the "
                    "address and the bitstream.",
                    FLOORLINE_VERSION_VALUE >> 16, id, version));
  }
  const std::uint32_t limits = bus_.read32(FLOORLINE_LIMITS);
  largest_frame_.width = field(limits, FLOORLINE_LIMITS_MAX_WIDTH_MASK, FLOORLINE_LIMITS_MAX_WIDTH_SHIFT);
  largest_frame_.height = field(limits, FLOORLINE_LIMITS_MAX_HEIGHT_MASK, FLOORLINE_LIMITS_MAX_HEIGHT_SHIFT);
  most_lines_ =
      std::size_t{1} << field(limits, FLOORLINE_LIMITS_LOG2_LINES_MASK, FLOORLINE_LIMITS_LOG2_LINES_SHIFT);
}

void Driver::enable(bool on) { bus_.write32(FLOORLINE_CONTROL, on ? FLOORLINE_CONTROL_ENABLE_MASK : 0); }

bool Driver::prepared_frame_started() { return bus_.read32(FLOORLINE_UPDATE) == 0; }

void Driver::prepare(const FrameParameters& parameters, const std::vector<LineSetup>& lines) {
  if (parameters.width.to_int() > largest_frame_.width ||
      parameters.height.to_int() > largest_frame_.height) {
    throw Error(fmt::format("A frame of {}x{} does not fit the core, which holds {}x{}: scale or crop it.",
                            parameters.width.to_int(), parameters.height.to_int(), largest_frame_.width,
                            largest_frame_.height));
  }
  if (lines.size() > most_lines_) {
    throw Error(fmt::format("{} lines do not fit the core: use at most {}.", lines.size(), most_lines_));
  }
  FrameParameters complete = parameters;
  complete.line_count = static_cast<unsigned>(lines.size());
  const auto values = register_values(complete);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!written_.empty() && written_[i] == values[i]) continue;
    bus_.write32(FLOORLINE_WIDTH + 4 * static_cast<std::uint32_t>(i), values[i]);
  }
  written_.assign(values.begin(), values.end());
  std::uint32_t update = FLOORLINE_UPDATE_PARAMETERS_MASK;
  if (!lines_in_use_ || !same(*lines_in_use_, lines)) {
    write_lines(lines);
    update |= FLOORLINE_UPDATE_LINES_MASK;
  }
  bus_.write32(FLOORLINE_UPDATE, update);
}

void Driver::write_lines(const std::vector<LineSetup>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const PackedElement words = pack(lines[i]);
    for (std::size_t word = 0; word < words.size(); ++word) {
      bus_.write32(static_cast<std::uint32_t>(FLOORLINE_LINES + FLOORLINE_LINE_BYTES * i + 4 * word),
                   words[word]);
    }
  }
  lines_in_use_ = lines;
}

std::uint32_t Driver::take_events() {
  const std::uint32_t events = bus_.read32(FLOORLINE_INTERRUPT_STATUS);
  bus_.write32(FLOORLINE_INTERRUPT_STATUS, events);
  return events;
}

void Driver::interrupt_on(std::uint32_t events) { bus_.write32(FLOORLINE_INTERRUPT_ENABLE, events); }

HardwareCounters Driver::counters() {
  HardwareCounters counters;
  counters.frames = bus_.read32(FLOORLINE_FRAMES);
  counters.malformed_frames = bus_.read32(FLOORLINE_MALFORMED_FRAMES);
  counters.dropped_frames = bus_.read32(FLOORLINE_DROPPED_FRAMES);
  counters.frame_cycles = bus_.read32(FLOORLINE_FRAME_CYCLES);
  counters.input_stalls = bus_.read32(FLOORLINE_INPUT_STALLS);
  counters.output_stalls = bus_.read32(FLOORLINE_OUTPUT_STALLS);
  counters.first_result_latency = bus_.read32(FLOORLINE_FIRST_RESULT_LATENCY);
  counters.decision_latency = bus_.read32(FLOORLINE_DECISION_LATENCY);
  counters.null_pixels = bus_.read32(FLOORLINE_NULL_PIXELS);
  counters.threshold_used = bus_.read32(FLOORLINE_THRESHOLD_USED);
  return counters;
}

}  // namespace floorline
