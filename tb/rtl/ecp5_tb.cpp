/// Test bench of `floorline-hlsc cosim`: the accelerator's Verilog, behind its C++ signature, against the
/// kernels themselves on frames of noise with a box that moves. Every element of every output must be the
/// same.
#include <cstdio>
#include <random>

#include "accelerator.h"

using namespace floorline;

void floorline_accelerator(hls::stream<RgbPixel>& pixels, hls::stream<FloorPoint>& points,
                           hls::stream<Obstacle>& obstacles, hls::stream<LineCount>& counts,
                           hls::stream<ap_uint<24> >& null_pixels, hls::stream<Pixel>& threshold_used,
                           const FrameParameters& parameters, const LineSetup lines[VgaConfig::MAX_LINES]);

namespace {

const int WIDTH = 80;
const int HEIGHT = 60;
const int LINES = 9;
const int FRAMES = 5;

FrameParameters frame_parameters() {
  FrameParameters parameters = FrameParameters();
  parameters.width = WIDTH;
  parameters.height = HEIGHT;
  parameters.grey = 1;
  parameters.replace_reference = 1;
  parameters.roi_last_row = HEIGHT - 1;
  parameters.line_count = LINES;
  parameters.cluster_gap = 1 << 14;
  parameters.homography.xu = 1 << 18;
  parameters.homography.yv = 1 << 18;
  parameters.homography.x1 = 100000 - (WIDTH / 2 << 18);
  parameters.homography.y1 = -(HEIGHT / 2 << 18);
  parameters.homography.z1 = 1 << 28;
  parameters.birdseye.xu = 2621;
  parameters.birdseye.yv = 2621;
  parameters.birdseye.z1 = 1 << 28;
  parameters.threshold.override_high = 40;
  parameters.threshold.low = 20;
  parameters.displacement.noise = 255;  // no foot test, since the whole box moves
  parameters.rule.run_rule = 1;
  parameters.rule.min_rows = 8;
  parameters.rule.max_gap = 2;
  parameters.rule.min_lines = 1;
  return parameters;
}

struct Streams {
  hls::stream<RgbPixel> pixels;
  hls::stream<FloorPoint> points;
  hls::stream<Obstacle> obstacles;
  hls::stream<LineCount> counts;
  hls::stream<ap_uint<24> > null_pixels;
  hls::stream<Pixel> threshold_used;
};

bool operator==(const FloorPoint& a, const FloorPoint& b) {
  return a.line == b.line && a.u == b.u && a.v == b.v && a.rows == b.rows && a.x == b.x && a.y == b.y &&
         a.clipped == b.clipped && a.end == b.end;
}

bool operator==(const Obstacle& a, const Obstacle& b) {
  return a.first_line == b.first_line && a.last_line == b.last_line && a.u == b.u && a.v == b.v &&
         a.rows == b.rows && a.x == b.x && a.y == b.y && a.clipped == b.clipped && a.end == b.end;
}

bool operator==(const LineCount& a, const LineCount& b) {
  return a.line == b.line && a.count == b.count && a.end == b.end;
}

/// How many elements two streams share; -1 where they differ.
template <typename Element>
int equal(hls::stream<Element>& hardware, hls::stream<Element>& software) {
  int count = 0;
  while (!hardware.empty() && !software.empty()) {
    if (!(hardware.read() == software.read())) return -1;
    ++count;
  }
  return hardware.empty() && software.empty() ? count : -1;
}

}  // namespace

int main() {
  static LineSetup lines[VgaConfig::MAX_LINES];
  for (int i = 0; i < LINES; ++i) {
    lines[i] = LineSetup();
    lines[i].first_column = 8 * (i + 1);
    lines[i].last_row = HEIGHT - 1;
    lines[i].first_run = 1;
    lines[i].last_run = 1;
    lines[i].divisor = 1;
  }
  std::mt19937 random(6);
  int points = 0;
  for (int frame = 0; frame < FRAMES; ++frame) {
    static Streams hardware, software;
    for (int v = 0; v < HEIGHT; ++v)
      for (int u = 0; u < WIDTH; ++u) {
        const int left = 8 + 9 * frame;
        const bool box = u >= left && u < left + 18 && v >= 12 && v < 40;
        const int grey = (box ? 190 : 60) + static_cast<int>(random() % 24);
        hardware.pixels.write(grey);
        software.pixels.write(grey);
      }
    const FrameParameters parameters = frame_parameters();
    floorline_accelerator(hardware.pixels, hardware.points, hardware.obstacles, hardware.counts,
                          hardware.null_pixels, hardware.threshold_used, parameters, lines);
    accelerator<VgaConfig>(software.pixels, software.points, software.obstacles, software.counts,
                           software.null_pixels, software.threshold_used, parameters, lines);
    const int same = equal(hardware.points, software.points);
    if (same < 0 || equal(hardware.obstacles, software.obstacles) < 0 ||
        equal(hardware.counts, software.counts) < 0 ||
        equal(hardware.null_pixels, software.null_pixels) < 0 ||
        equal(hardware.threshold_used, software.threshold_used) < 0) {
      std::printf("frame %d: Verilog and kernels differ\n", frame);
      return 1;
    }
    points += same - 1;
  }
  std::printf("%d points are the same\n", points);
  return points > 0 ? 0 : 1;
}
