/// Test bench for the vendors' C simulation and co-simulation: three small frames with a box that moves.
/// Checks what must hold of every result, so that it needs no golden data: each packet ends once, every line
/// is counted, contacts lie inside the frame, and the moving box is found where it touches the floor. Exit
/// code 0: passed. Strict C++11.
#include <cstdio>

#include "accelerator.h"

using namespace floorline;

namespace {

const int WIDTH = 64;
const int HEIGHT = 48;
const int LINES = 7;
const int BOX_TOP = 12;
const int BOX_FOOT = 35;
const int BOX_WIDTH = 16;

int failures = 0;

void expect(bool holds, const char* what, int frame) {
  if (holds) return;
  std::printf("frame %d: %s\n", frame, what);
  ++failures;
}

RgbPixel pixel_at(int u, int v, int frame) {
  const int left = 8 + 12 * frame;
  const bool box = u >= left && u < left + BOX_WIDTH && v >= BOX_TOP && v <= BOX_FOOT;
  return box ? 200 : 60;
}

FrameParameters frame_parameters() {
  FrameParameters parameters = FrameParameters();
  parameters.width = WIDTH;
  parameters.height = HEIGHT;
  parameters.grey = 1;
  parameters.replace_reference = 1;
  parameters.roi_last_row = HEIGHT - 1;
  parameters.line_count = LINES;
  parameters.homography.xu = 1 << 18;
  parameters.homography.yv = 1 << 18;
  parameters.homography.x1 = -(WIDTH / 2 << 18);
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

/// Upright lines, every 8 columns.
void fill_lines(LineSetup lines[VgaConfig::MAX_LINES]) {
  for (int i = 0; i < LINES; ++i) {
    LineSetup line = LineSetup();
    line.first_column = 8 * (i + 1);
    line.last_row = HEIGHT - 1;
    line.first_run = 1;
    line.last_run = 1;
    line.divisor = 1;
    lines[i] = line;
  }
}

/// Reads a packet of points; returns how many there were before its end.
int check_points(hls::stream<FloorPoint>& points, int frame, bool& at_foot) {
  int count = 0;
  at_foot = false;
  while (!points.empty()) {
    const FloorPoint point = points.read();
    if (point.end) return count;
    ++count;
    expect(point.u >= 0 && point.u < WIDTH && point.v < HEIGHT, "a contact lies outside the frame", frame);
    // The 3x3 blur smears the foot by a row.
    if (point.v >= BOX_FOOT - 1 && point.v <= BOX_FOOT + 1) at_foot = true;
  }
  expect(false, "the points have no end element", frame);
  return count;
}

}  // namespace

int main() {
  static LineSetup lines[VgaConfig::MAX_LINES];
  fill_lines(lines);
  for (int frame = 0; frame < 3; ++frame) {
    hls::stream<RgbPixel> pixels("pixels");
    hls::stream<FloorPoint> points("points");
    hls::stream<Obstacle> obstacles("obstacles");
    hls::stream<LineCount> counts("counts");
    hls::stream<ap_uint<24> > null_pixels("null_pixels");
    hls::stream<Pixel> threshold_used("threshold_used");
    for (int v = 0; v < HEIGHT; ++v)
      for (int u = 0; u < WIDTH; ++u) pixels.write(pixel_at(u, v, frame));
    const FrameParameters parameters = frame_parameters();
    floorline_accelerator(pixels, points, obstacles, counts, null_pixels, threshold_used, parameters, lines);

    bool at_foot = false;
    const int found = check_points(points, frame, at_foot);
    if (frame == 0) {
      expect(found == 0, "contacts without a reference", frame);
    } else {
      expect(at_foot, "the moving box was not found at its foot", frame);
    }
    int lines_counted = 0;
    while (!counts.empty()) {
      const LineCount count = counts.read();
      expect(count.line == lines_counted, "line counts out of order", frame);
      ++lines_counted;
      expect((count.end == 1) == (lines_counted == LINES), "the line counts end early or late", frame);
    }
    expect(lines_counted == LINES, "a line was not counted", frame);
    bool ended = false;
    while (!obstacles.empty()) {
      expect(!ended, "obstacles after their end element", frame);
      ended = obstacles.read().end == 1;
    }
    expect(ended, "the obstacles have no end element", frame);
    const unsigned nulls = null_pixels.read().to_uint();
    expect(frame == 0 ? nulls == WIDTH * HEIGHT : nulls < WIDTH * HEIGHT / 4, "wrong number of null pixels",
           frame);
    expect(threshold_used.read() == parameters.threshold.override_high, "another threshold than asked for",
           frame);
  }
  std::printf(failures == 0 ? "passed\n" : "failed\n");
  return failures == 0 ? 0 : 1;
}
