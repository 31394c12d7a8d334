#include "tb/cosim/cycle_table.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "host/driver.h"
#include "host/line_table.h"
#include "tb/cosim/top.h"
#include "tb/cosim/video.h"

namespace floorline::cosim {
namespace {

/// Identity homography, a floor on which a pixel is a centimetre, run rule.
FrameParameters parameters(cv::Size size) {
  FrameParameters p = {};
  p.width = size.width;
  p.height = size.height;
  p.grey = 1;
  p.replace_reference = 1;
  p.erode_high = 0;
  p.roi_last_row = size.height - 1;
  p.cluster_gap = 1 << 14;
  p.homography.xu = p.homography.yv = 1 << 18;
  p.homography.x1 = -(size.width / 2 << 18);
  p.homography.y1 = -(size.height / 2 << 18);
  p.homography.z1 = 1 << 28;
  p.birdseye.xv = p.birdseye.yu = -2621;
  p.birdseye.x1 = 3 << 18;
  p.birdseye.z1 = 1 << 28;
  p.threshold.floor = 20;
  p.threshold.low = 10;
  p.displacement.noise = 255;
  p.rule.run_rule = 1;
  p.rule.min_rows = 3;
  p.rule.max_gap = 3;
  p.rule.min_lines = 2;
  return p;
}

/// As many lines as the polar engine walks at this width, at most the default number of host/parameters.h.
std::vector<LineSetup> lines(cv::Size size, int last_row) {
  constexpr int kLessThanWidth = 16, kMost = 256;
  const int count = std::min(kMost, size.width - kLessThanWidth);
  if (count < 1) return {};
  const Eigen::Vector3d focus(size.width / 2.0, 4.0 * size.height, 1);
  return line_table(beam_lines({focus, size, 0, last_row, count}), size);
}

/// Boxes on a flat floor, which jump from frame to frame; the last one stands in the last rows.
cv::Mat scene(cv::Size size, int frame) {
  cv::Mat image(size, CV_8UC1, cv::Scalar(60));
  for (int box = 0; box < 4; ++box) {
    const int u = size.width * (2 * box + frame % 2) / 8, foot = size.height * (box + 2) / 5;
    cv::rectangle(image, {u, foot - size.height / 3, size.width / 8, size.height / 3}, cv::Scalar(200),
                  cv::FILLED);
  }
  return image;
}

/// Of a frame for itself: all stages start with it, and none waits for the frame before.
std::vector<StageRun> measure_stages(Top& top, const cv::Mat& frame) {
  constexpr int kOtsuSearch = 2000;  // After the last result; its cycles are in docs/cosimulation.md.
  const auto finish = [&](std::size_t frames) {
    top.run_until([&] { return top.obstacles().packets.size() == frames; });
    for (int i = 0; i < kOtsuSearch; ++i) top.tick();
  };
  const std::size_t before = top.obstacles().packets.size();
  finish(before);
  top.take_activity();
  queue_video(frame, 0, frame.rows, top.video().queue);
  finish(before + 1);
  return top.take_activity().stages;
}

}  // namespace

const std::vector<CycleCase>& cycle_cases() {
  static const std::vector<CycleCase> cases = {
      {{16, 16}, Stalls::none},    {{17, 19}, Stalls::none},   {{33, 16}, Stalls::none},
      {{64, 48}, Stalls::none},    {{161, 121}, Stalls::none}, {{320, 240}, Stalls::none},
      {{640, 120}, Stalls::none},  {{639, 479}, Stalls::none}, {{640, 480}, Stalls::none},
      {{1280, 384}, Stalls::none}, {{64, 48}, Stalls::light},  {{161, 121}, Stalls::heavy}};
  return cases;
}

CycleRow measure_cycles(cv::Size size, Stalls stalls) {
  constexpr std::uint32_t kFrames = 4;  // The third is steady: frames before and after it.
  Top top(configuration_for(size), stalls, 0);
  Driver driver(top);
  const int last_row = size.height - 1 - (stalls == Stalls::none ? 0 : size.height / 8);
  driver.prepare(parameters(size), lines(size, last_row));
  driver.enable(true);
  for (std::uint32_t i = 0; i < kFrames; ++i) {
    queue_video(scene(size, static_cast<int>(i)), 0, size.height, top.video().queue);
  }
  top.run_until([&] { return top.obstacles().packets.size() == kFrames; });
  const HardwareCounters counters = driver.counters();
  return {size,
          stalls,
          counters.frame_cycles,
          counters.input_stalls,
          counters.output_stalls,
          counters.first_result_latency,
          counters.decision_latency,
          measure_stages(top, scene(size, 1))};
}

}  // namespace floorline::cosim
