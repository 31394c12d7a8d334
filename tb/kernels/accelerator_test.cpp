#include "hls/accelerator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <random>

#include "host/error.h"
#include "host/fixed_point.h"
#include "host/line_table.h"
#include "tb/csim/csim.h"

namespace floorline {

inline bool operator==(const FloorPoint& a, const FloorPoint& b) {
  return a.line == b.line && a.u == b.u && a.v == b.v && a.rows == b.rows && a.x == b.x && a.y == b.y &&
         a.clipped == b.clipped && a.end == b.end;
}

inline bool operator==(const Obstacle& a, const Obstacle& b) {
  return a.first_line == b.first_line && a.last_line == b.last_line && a.u == b.u && a.v == b.v &&
         a.rows == b.rows && a.x == b.x && a.y == b.y && a.clipped == b.clipped && a.end == b.end;
}

inline bool operator==(const LineCount& a, const LineCount& b) {
  return a.line == b.line && a.count == b.count && a.end == b.end;
}

namespace {

const cv::Size kImage(160, 120);

/// Identity homography, and a floor on which a pixel is a centimetre; no thresholds but the low and the floor
/// one, no foot test.
FrameParameters parameters(cv::Size image = kImage) {
  FrameParameters p = {};
  p.replace_reference = 1;
  p.roi_first_row = 10;
  p.roi_last_row = 119;
  p.cluster_gap = 1 << 14;
  p.homography = pack_homography(Eigen::Matrix3d::Identity(), image, cv::Rect({}, image)).map;
  p.birdseye.xv = -2621;
  p.birdseye.x1 = 3 << 18;
  p.birdseye.yu = -2621;
  p.birdseye.y1 = 209715;
  p.birdseye.z1 = 1 << 28;
  p.threshold.floor = 20;
  p.threshold.low = 10;
  p.displacement.noise = 255;
  p.rule.run_rule = 1;
  p.rule.min_rows = 12;
  p.rule.max_gap = 3;
  p.rule.min_lines = 2;
  return p;
}

std::vector<LineSetup> beam() { return line_table(beam_lines({{80, 600, 1}, kImage, 10, 119, 64}), kImage); }

/// A flat floor, and on it a box whose foot is in row `foot` and that moves with the frame number.
cv::Mat scene(int frame, int foot) {
  cv::Mat image(kImage, CV_8UC1, cv::Scalar(60));
  cv::rectangle(image, {40 + 12 * (frame % 3), foot - 50, 24, 50}, cv::Scalar(200), cv::FILLED);
  return image;
}

TEST(Accelerator, ReportsAnObstacleThatAppears) {
  CSimulation csim(kImage);
  EXPECT_EQ(csim.run(scene(0, 70), parameters(), beam()).null_pixels, kImage.area()) << "no reference yet";
  const FrameOutput output = csim.run(cv::Mat(kImage, CV_8UC1, cv::Scalar(60)), parameters(), beam());
  ASSERT_EQ(output.obstacles.size(), 1u);
  const Obstacle obstacle = output.obstacles[0];
  EXPECT_NEAR(obstacle.v.to_int(), 69, 2);
  EXPECT_NEAR(obstacle.u.to_int(), 52, 16);
  EXPECT_NEAR(obstacle.x.to_double() / 65536, 3 - 0.01 * 69, 0.03);
  EXPECT_EQ(output.null_pixels, 0);
  EXPECT_EQ(output.counts.size(), beam().size());
}

TEST(Accelerator, SeesNothingWhereNothingChanges) {
  CSimulation csim(kImage);
  csim.run(scene(0, 70), parameters(), beam());
  const FrameOutput output = csim.run(scene(0, 70), parameters(), beam());
  EXPECT_TRUE(output.points.empty());
  EXPECT_TRUE(output.obstacles.empty());
}

TEST(Accelerator, HoldsItsReference) {
  CSimulation csim(kImage);
  csim.run(scene(0, 70), parameters(), beam());
  FrameParameters hold = parameters();
  hold.replace_reference = 0;
  csim.run(scene(1, 70), hold, beam());
  EXPECT_TRUE(csim.run(scene(0, 70), hold, beam()).points.empty())
      << "the second frame must not be the reference";
}

TEST(Accelerator, RunsWithoutLines) {
  CSimulation csim(kImage);
  const FrameOutput output = csim.run(scene(0, 70), parameters(), {});
  EXPECT_TRUE(output.points.empty());
  EXPECT_TRUE(output.counts.empty());
}

/// The streams of a concrete top for one colour frame, drained.
template <typename Config>
FrameOutput run_top(decltype(floorline_accelerator)* top, const cv::Mat& image, FrameParameters p,
                    std::vector<LineSetup> lines) {
  hls::stream<RgbPixel> pixels("pixels");
  hls::stream<FloorPoint> points("points");
  hls::stream<Obstacle> obstacles("obstacles");
  hls::stream<LineCount> counts("counts");
  hls::stream<ap_uint<24>> null_pixels("null_pixels");
  hls::stream<Pixel> threshold_used("threshold_used");
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const cv::Vec3b bgr = image.at<cv::Vec3b>(v, u);
      pixels.write((Pixel(bgr[2]), Pixel(bgr[0]), Pixel(bgr[1])));
    }
  }
  p.width = image.cols;
  p.height = image.rows;
  p.line_count = lines.size();
  lines.resize(Config::MAX_LINES);
  top(pixels, points, obstacles, counts, null_pixels, threshold_used, p, lines.data());
  EXPECT_TRUE(pixels.empty());
  FrameOutput output;
  for (FloorPoint point = points.read(); !point.end; point = points.read()) output.points.push_back(point);
  for (Obstacle obstacle = obstacles.read(); !obstacle.end; obstacle = obstacles.read()) {
    output.obstacles.push_back(obstacle);
  }
  while (!counts.empty()) output.counts.push_back(counts.read());
  output.null_pixels = null_pixels.read().to_int();
  output.threshold_used = threshold_used.read().to_int();
  return output;
}

TEST(Accelerator, CapturedStagesGiveWhatTheTopGives) {
  std::mt19937 random(9);
  std::vector<cv::Mat> frames;
  std::vector<FrameParameters> settings;
  for (int i = 0; i < 8; ++i) {
    cv::Mat frame;
    cv::cvtColor(scene(i, 60 + 5 * i), frame, cv::COLOR_GRAY2BGR);
    cv::Mat noise(frame.size(), CV_8UC3);
    cv::randu(noise, 0, 5 * i + 1);
    frames.push_back(frame + noise);
    FrameParameters p = parameters();
    p.replace_reference = i % 3 != 1;
    p.displacement.noise = i % 2 ? 255 : 2;
    p.erode_high = i % 4 == 3;
    p.rule.run_rule = i % 5 != 4;
    settings.push_back(p);
  }
  std::vector<FrameOutput> captured, plain;
  CSimulation first(kImage);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    StageCapture capture;
    captured.push_back(first.run(frames[i], settings[i], beam(), &capture));
    EXPECT_EQ(capture.region.size(), kImage);
    EXPECT_EQ(capture.contacts.size(), captured.back().points.size());
  }
  CSimulation second(kImage);
  for (std::size_t i = 0; i < frames.size(); ++i) plain.push_back(second.run(frames[i], settings[i], beam()));
  std::size_t points = 0;
  CSimulation reset(kImage);  // The concrete top shares the kernels' state.
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const FrameOutput top = run_top<VgaConfig>(floorline_accelerator, frames[i], settings[i], beam());
    for (const FrameOutput* output : {&captured[i], &plain[i]}) {
      EXPECT_EQ(output->points, top.points);
      EXPECT_EQ(output->obstacles, top.obstacles);
      EXPECT_EQ(output->counts, top.counts);
      EXPECT_EQ(output->null_pixels, top.null_pixels);
      EXPECT_EQ(output->threshold_used, top.threshold_used);
    }
    points += top.points.size();
  }
  EXPECT_GT(points, 50u) << "the frames must show something to compare";
}

TEST(CSimulation, RefusesFramesThatFitNoConfiguration) {
  EXPECT_THROW(CSimulation({1280, 720}), Error);
  CSimulation csim(kImage);
  EXPECT_THROW(csim.run(cv::Mat::zeros(481, 640, CV_8UC1), parameters(), {}), Error);
  EXPECT_THROW(csim.run(cv::Mat::zeros(120, 160, CV_16UC1), parameters(), {}), Error);
  EXPECT_THROW(csim.run(cv::Mat::zeros(120, 160, CV_8UC1), parameters(), std::vector<LineSetup>(257)), Error);
}

TEST(CSimulation, TakesWideFrames) {
  const cv::Mat image = cv::Mat::zeros(370, 1226, CV_8UC3);
  CSimulation csim(image.size());
  const std::vector<LineSetup> lines =
      line_table(beam_lines({{0, 600, 0}, image.size(), 200, 369, 256}), image.size());
  const FrameOutput output = csim.run(image, parameters(image.size()), lines);
  EXPECT_EQ(output.null_pixels, image.size().area());
  const FrameOutput top =
      run_top<WideConfig>(floorline_accelerator_wide, image, parameters(image.size()), lines);
  EXPECT_EQ(top.null_pixels, 0) << "the frame before is the reference";
  EXPECT_EQ(top.counts, output.counts);
}

}  // namespace
}  // namespace floorline
