#include "cosim_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "output.h"
#include "svg.h"
#include "wave_picture.h"

namespace floorline::app {
namespace {

const char* verdict(bool ok) { return ok ? "ok" : "short"; }

nlohmann::json comparison_section(const CosimSummary& s) {
  const auto stream = [&](const char* name, long bits, std::size_t elements) {
    return nlohmann::json{name, elements, bits, verdict(bits == 0)};
  };
  return {
      {"title", "RTL against C simulation"},
      {"note", fmt::format("{} frames of {}x{} in Verilator, stalls: {}. Every bit of every stream.",
                           s.frames(), s.size.width, s.size.height, s.stalls)},
      {"columns", {"stream", "elements", "differing bits", "verdict"}},
      {"rows",
       {stream("points", s.sum(&cosim::FrameVerdict::points), s.sum(&cosim::FrameVerdict::point_count)),
        stream("obstacles", s.sum(&cosim::FrameVerdict::obstacles),
               s.sum(&cosim::FrameVerdict::obstacle_count)),
        stream("line counts", s.sum(&cosim::FrameVerdict::counts), s.sum(&cosim::FrameVerdict::line_count)),
        stream("taps", s.sum(&cosim::FrameVerdict::taps), s.sum(&cosim::FrameVerdict::tap_count)),
        stream("registers", s.sum(&cosim::FrameVerdict::registers), s.frames())}}};
}

nlohmann::json cycles_section(const CosimSummary& s) {
  constexpr std::uint32_t kPaperLatency = 4610;
  const std::uint32_t cycles_bound = s.size.area() + 1000, latency_bound = 2200;
  const std::uint32_t decision = s.greatest(&HardwareCounters::decision_latency);
  return {
      {"title", "Cycles and latencies"},
      {"note",
       "The core's own counters, greatest of all frames; a frame's bound is for one without stalls. The ICVS "
       "paper needs about 4,610 cycles to a contact point; its frames take width * height cycles."},
      {"columns", {"counter", "cycles", "bound", "paper", "verdict"}},
      {"rows",
       {{"frame", s.most_cycles(), cycles_bound, s.size.area(), verdict(s.most_cycles() <= cycles_bound)},
        {"last pixel of the deciding row to point", decision, latency_bound, kPaperLatency,
         verdict(decision <= latency_bound)},
        {"first pixel to first result", s.greatest(&HardwareCounters::first_result_latency), "", "", ""}}}};
}

/// Frames by their greatest decision latency, in at most sixteen classes.
std::string latency_histogram(const CosimSummary& s) {
  constexpr std::uint32_t kClasses = 16, kRound = 50;
  constexpr int kBar = 44, kHeight = 140, kFoot = 40;
  std::vector<std::uint32_t> latencies;
  for (const cosim::FrameVerdict& frame : s.result.frames) {
    if (frame.counters.decision_latency != 0) latencies.push_back(frame.counters.decision_latency);
  }
  if (latencies.empty())
    return svg::picture(300, 30, svg::label(0, 20, "start", "no contact in these frames"));
  const auto [least, greatest] = std::minmax_element(latencies.begin(), latencies.end());
  const std::uint32_t width = kRound * (1 + (*greatest - *least) / (kRound * (kClasses - 1)));
  const std::uint32_t first = *least / width;
  std::vector<int> counts(*greatest / width - first + 1);
  for (const std::uint32_t latency : latencies) ++counts[latency / width - first];
  const int most = *std::max_element(counts.begin(), counts.end());
  std::string body;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const int x = static_cast<int>(i) * kBar, height = counts[i] * (kHeight - 20) / most;
    body += svg::box(x + 2, kHeight - height, kBar - 4, height, svg::kBlue);
    if (counts[i] != 0)
      body += svg::label(x + kBar / 2, kHeight - height - 4, "middle", std::to_string(counts[i]));
    body += svg::label(x + kBar / 2, kHeight + 16, "middle", std::to_string((first + i) * width));
  }
  return svg::picture(std::max(320, static_cast<int>(counts.size()) * kBar), kHeight + kFoot,
                      body + svg::label(0, kHeight + 34, "start", "cycles, from; frames on the bars"));
}

/// A row a FIFO, a column a frame: blue where its reader found nothing, red where its writer found no room.
std::string stall_map(const CosimSummary& s) {
  constexpr int kLeft = 110, kRow = 18, kFoot = 24, kWidth = 640;
  const auto& frames = s.result.frames;
  const int cell = std::max(2, kWidth / static_cast<int>(frames.size()));
  const std::size_t channels = frames.front().activity.channels.size();
  std::string body;
  for (std::size_t c = 0; c < channels; ++c) {
    const int y = static_cast<int>(c) * kRow;
    body += svg::label(kLeft - 8, y + 13, "end", frames.front().activity.channels[c].name);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const cosim::ChannelCounts& counts = frames[i].activity.channels[c];
      const auto share = [&](std::uint64_t part) {
        return static_cast<int>(255 * part / std::max<std::uint64_t>(1, counts.cycles));
      };
      const int empty = share(counts.empty), full = share(counts.full);
      body += svg::box(kLeft + static_cast<int>(i) * cell, y, cell, kRow - 2,
                       fmt::format("rgb({},{},{})", 255 - empty, 255 - (empty + full) / 2, 255 - full));
    }
  }
  const int height = static_cast<int>(channels) * kRow;
  return svg::picture(
      kLeft + cell * static_cast<int>(frames.size()), height + kFoot,
      body + svg::label(kLeft, height + 16, "start", "frames; blue: empty, red: full, white: words pass"));
}

/// The FIFOs over all frames.
nlohmann::json channels_section(const CosimSummary& s) {
  std::vector<cosim::ChannelCounts> sums;
  for (const cosim::FrameVerdict& frame : s.result.frames) {
    if (sums.empty()) {
      sums = frame.activity.channels;
      continue;
    }
    for (std::size_t c = 0; c < sums.size(); ++c) {
      sums[c].cycles += frame.activity.channels[c].cycles;
      sums[c].empty += frame.activity.channels[c].empty;
      sums[c].full += frame.activity.channels[c].full;
      sums[c].most = std::max(sums[c].most, frame.activity.channels[c].most);
    }
  }
  nlohmann::json rows = nlohmann::json::array();
  for (const cosim::ChannelCounts& sum : sums) {
    const auto percent = [&](std::uint64_t part) {
      return fmt::format("{:.1f}", 100.0 * static_cast<double>(part) / static_cast<double>(sum.cycles));
    };
    rows.push_back({sum.name, sum.depth, sum.most, percent(sum.empty), percent(sum.full)});
  }
  return {{"title", "Stalls over the pipeline"},
          {"note",
           "FIFOs between the stages, in their order: how many words they held at most, and in how many of "
           "all cycles the "
           "reader found nothing or the writer no room."},
          {"columns", {"FIFO", "depth", "most words", "empty, %", "full, %"}},
          {"rows", rows}};
}

}  // namespace

void write_hardware_sections(const CosimSummary& summary, const std::filesystem::path& file) {
  const auto picture = [&](const char* name, const std::string& content) {
    const std::string beside = file.stem().string() + "_" + name + ".svg";
    produce_file(file.parent_path() / beside, content);
    return beside;
  };
  nlohmann::json cycles = cycles_section(summary), channels = channels_section(summary);
  const nlohmann::json latencies = {
      {"title", "Latency"},
      {"note", "From the last pixel of the deciding row to the floor point: the greatest of each frame."},
      {"picture", picture("latency", latency_histogram(summary))}};
  channels["picture"] = picture("stalls", stall_map(summary));
  nlohmann::json sections = {comparison_section(summary), cycles, latencies, channels};
  if (summary.result.watch) {
    const std::size_t failure = summary.result.first_failure().value();
    sections.push_back(
        {{"title", "The first difference"},
         {"note", fmt::format("Frame {}: {}. What stands on the ports; the element's cycle is shaded.",
                              failure, summary.result.frames[failure].first_difference->words)},
         {"picture", picture("waves", wave_picture(*summary.result.watch))}});
  }
  produce_file(file, sections.dump(2) + "\n");
}

}  // namespace floorline::app
