#include "tb/csim/csim.h"

#include <string>

#include "golden/displacement.h"
#include "hls/accelerator.h"
#include "host/error.h"

namespace floorline {
namespace {

/// Reads a frame of elements up to the one whose `end` is set. LineCount's end element counts, unless there
/// is no line.
template <typename Element>
std::vector<Element> drain(hls::stream<Element>& stream) {
  std::vector<Element> elements;
  for (Element element = stream.read(); !element.end; element = stream.read()) elements.push_back(element);
  return elements;
}

std::vector<LineCount> drain_counts(hls::stream<LineCount>& stream, bool has_lines) {
  std::vector<LineCount> counts;
  do counts.push_back(stream.read());
  while (!counts.back().end);
  if (!has_lines) counts.clear();
  return counts;
}

/// Takes a frame of elements out of a stream and puts it back; the image shows `value` of each element.
template <typename Element, typename Value>
cv::Mat tap(hls::stream<Element>& stream, cv::Size size, Value value) {
  cv::Mat image(size, CV_8UC1);
  for (int v = 0; v < size.height; ++v) {
    uchar* row = image.ptr(v);
    for (int u = 0; u < size.width; ++u) {
      const Element element = stream.read();
      row[u] = static_cast<uchar>(value(element).to_uint());
      stream.write(element);
    }
  }
  return image;
}

template <typename Element>
cv::Mat tap(hls::stream<Element>& stream, cv::Size size) {
  return tap(stream, size, [](const Element& element) { return element; });
}

void send(const cv::Mat& image, hls::stream<RgbPixel>& pixels) {
  for (int v = 0; v < image.rows; ++v) {
    const uchar* row = image.ptr(v);
    for (int u = 0; u < image.cols; ++u) {
      if (image.channels() == 1) {
        pixels.write(row[u]);
      } else {
        const uchar* bgr = row + 3 * u;
        pixels.write(bgr[2] << 16 | bgr[0] << 8 | bgr[1]);
      }
    }
  }
}

/// The stages of hls/accelerator.h in the same order, with the streams between them looked at. That both give
/// the same is accelerator_test's to show.
template <typename Config>
void run_captured(hls::stream<RgbPixel>& pixels, hls::stream<FloorPoint>& points,
                  hls::stream<Obstacle>& obstacles, hls::stream<LineCount>& counts,
                  hls::stream<ap_uint<24>>& null_pixels, hls::stream<Pixel>& threshold_used,
                  const FrameParameters& p, const LineSetup* lines, StageCapture& capture) {
  constexpr int kWidth = Config::MAX_WIDTH;
  constexpr int kHeight = Config::MAX_HEIGHT;
  const cv::Size size(p.width.to_int(), p.height.to_int());
  hls::stream<Pixel> luma_out("luma_out"), difference_out("difference_out"), blurred("blurred"),
      measured("measured"), thresholds("thresholds");
  hls::stream<PixelPair> pairs("pairs");
  hls::stream<Change> changes("changes");
  hls::stream<Motion> motions("motions");
  hls::stream<Mask> binary("binary"), eroded("eroded"), region("region");
  hls::stream<Contact> contacts("contacts");
  hls::stream<FloorPoint> floor_points("floor_points"), candidates("candidates");

  luma<kWidth, kHeight>(pixels, luma_out, p.width, p.height, p.grey);
  capture.luma = tap(luma_out, size);
  frame_ring<kWidth, kHeight, Config::MARGIN>(luma_out, pairs, null_pixels, p.width, p.height,
                                              p.replace_reference, p.homography);
  capture.reference = tap(pairs, size, [](const PixelPair& pair) { return pair.reference; });
  capture.gradient = tap(pairs, size, [](const PixelPair& pair) { return pair.gradient; });
  capture.valid = tap(pairs, size, [](const PixelPair& pair) { return pair.valid; });
  difference<kWidth, kHeight>(pairs, difference_out, changes, p.width, p.height);
  capture.difference = tap(difference_out, size);
  displacement<kWidth, kHeight>(changes, motions, p.width, p.height, p.displacement);
  capture.motion = tap(motions, size);
  gaussian<kWidth, kHeight>(difference_out, blurred, p.width, p.height);
  capture.blurred = tap(blurred, size);
  otsu<kWidth, kHeight>(blurred, measured, thresholds, p.width, p.height);
  capture.otsu_threshold = tap(thresholds, {1, 1}).at<uchar>(0);
  binarize<kWidth, kHeight>(measured, thresholds, binary, threshold_used, p.width, p.height, p.threshold);
  capture.binary = tap(binary, size);
  erode<kWidth, kHeight>(binary, eroded, p.width, p.height, p.erode_high);
  capture.eroded = tap(eroded, size);
  roi<kWidth, kHeight>(eroded, region, p.width, p.height, p.roi_first_row, p.roi_last_row);
  capture.region = tap(region, size);
  polar<kWidth, kHeight, Config::MAX_LINES>(region, motions, contacts, counts, p.width, p.height,
                                            p.line_count, p.rule, lines);
  capture.contacts = drain(contacts);
  for (const Contact& contact : capture.contacts) contacts.write(contact);
  contacts.write(Contact{0, 0, 0, 0, 0, 1});
  birdseye(contacts, floor_points, p.birdseye);
  duplicate(floor_points, points, candidates);
  cluster<Config::MAX_LINES>(candidates, obstacles, p.line_count, p.cluster_gap, p.rule.min_lines);
}

template <typename Config>
FrameOutput run_frame(const cv::Mat& image, const FrameParameters& parameters, std::vector<LineSetup> lines,
                      StageCapture* capture) {
  hls::stream<RgbPixel> pixels("pixels");
  hls::stream<FloorPoint> points("points");
  hls::stream<Obstacle> obstacles("obstacles");
  hls::stream<LineCount> counts("counts");
  hls::stream<ap_uint<24>> null_pixels("null_pixels");
  hls::stream<Pixel> threshold_used("threshold_used");
  lines.resize(Config::MAX_LINES);
  send(image, pixels);
  if (capture) {
    run_captured<Config>(pixels, points, obstacles, counts, null_pixels, threshold_used, parameters,
                         lines.data(), *capture);
  } else {
    accelerator<Config>(pixels, points, obstacles, counts, null_pixels, threshold_used, parameters,
                        lines.data());
  }
  return {drain(points), drain(obstacles), drain_counts(counts, parameters.line_count != 0),
          null_pixels.read().to_int(), threshold_used.read().to_int()};
}

template <typename Config>
bool holds(cv::Size size) {
  return size.width <= Config::MAX_WIDTH && size.height <= Config::MAX_HEIGHT;
}

/// A held frame of a size that no real one has drops the reference, its single grey level the threshold.
constexpr int kResetSide = 16;

std::string text(cv::Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

}  // namespace

cv::Mat motion_grey(const cv::Mat& motions) {
  cv::Mat levels = cv::Mat::zeros(1, 256, CV_8UC1), grey;
  levels.at<uchar>(RESTS) = golden::rests;
  levels.at<uchar>(STIRS) = golden::stirs;
  levels.at<uchar>(UNKNOWN) = golden::unknown_motion;
  levels.at<uchar>(MOVES) = golden::moves;
  cv::LUT(motions, levels, grey);
  return grey;
}

CSimulation::CSimulation(cv::Size largest_frame) {
  if (holds<VgaConfig>(largest_frame)) {
    maximum_ = {VgaConfig::MAX_WIDTH, VgaConfig::MAX_HEIGHT};
    most_lines_ = VgaConfig::MAX_LINES;
    frame_ = run_frame<VgaConfig>;
  } else if (holds<WideConfig>(largest_frame)) {
    maximum_ = {WideConfig::MAX_WIDTH, WideConfig::MAX_HEIGHT};
    most_lines_ = WideConfig::MAX_LINES;
    frame_ = run_frame<WideConfig>;
  } else {
    throw Error("Frames of " + text(largest_frame) +
                " fit no configuration: scale or crop them to 640x480 or 1280x384.");
  }
  run(cv::Mat::zeros(kResetSide, kResetSide, CV_8UC1), FrameParameters(), {});
}

FrameOutput CSimulation::run(const cv::Mat& image, FrameParameters parameters,
                             const std::vector<LineSetup>& lines, StageCapture* capture) {
  if (image.type() != CV_8UC1 && image.type() != CV_8UC3) {
    throw Error("A frame must be 8-bit grey or colour: convert the images first.");
  }
  if (image.cols > maximum_.width || image.rows > maximum_.height || image.cols < kResetSide ||
      image.rows < 1) {
    throw Error("A frame of " + text(image.size()) + " does not fit the accelerator built for " +
                text(maximum_) + ": all frames of a sequence must have the same size.");
  }
  if (lines.size() > most_lines_) {
    throw Error(std::to_string(lines.size()) + " lines do not fit the accelerator: use at most " +
                std::to_string(most_lines_) + ".");
  }
  parameters.width = image.cols;
  parameters.height = image.rows;
  parameters.grey = image.channels() == 1;
  parameters.line_count = static_cast<unsigned>(lines.size());
  return frame_(image, parameters, lines, capture);
}

}  // namespace floorline
