/// Prints how many VGA frames a second the C simulation runs, as a figure:
/// name<TAB>value<TAB>bound<TAB>ok|short.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <opencv2/core.hpp>

#include "host/line_table.h"
#include "tb/csim/csim.h"

int main() {
  using namespace floorline;
  constexpr int kFrames = 12;
  constexpr double kBound = 10.0;
  const cv::Size size(640, 480);
  FrameParameters parameters = {};
  parameters.replace_reference = 1;
  parameters.erode_high = 1;
  parameters.roi_last_row = size.height - 1;
  parameters.homography.xu = parameters.homography.yv = 1 << 18;
  parameters.homography.z1 = 1 << 28;
  parameters.birdseye.xv = parameters.birdseye.yu = -1000;
  parameters.birdseye.x1 = 4 << 18;
  parameters.birdseye.z1 = 1 << 28;
  parameters.rule.run_rule = 1;
  parameters.rule.min_rows = 2;
  const auto lines = line_table(beam_lines({{320, 2000, 1}, size, 0, size.height - 1, 128}), size);

  CSimulation csim(size);
  cv::Mat frame(size, CV_8UC3);
  std::size_t points = 0;
  double best = 0.0;
  for (int i = 0; i < kFrames; ++i) {
    cv::randu(frame, 0, 256);  // Every pixel differs from the frame before: as much work as a frame can make.
    const auto start = std::chrono::steady_clock::now();
    points += csim.run(frame, parameters, lines).points.size();
    best =
        std::max(best, 1.0 / std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::printf("csim.frames_per_second\t%.1f\t>= %.0f\t%s\n", best, kBound,
              best >= kBound && points > 0 ? "ok" : "short");
}
