#include "golden/pipeline.h"

#include <utility>

#include "golden/difference.h"
#include "golden/displacement.h"
#include "golden/erode.h"
#include "golden/gaussian.h"
#include "golden/luma.h"
#include "golden/otsu.h"
#include "golden/roi.h"

namespace floorline::golden {

Pipeline::Pipeline(int ring_rows, std::optional<Lens> lens) : ring_(ring_rows), lens_(std::move(lens)) {}

Stages Pipeline::process(const cv::Mat& image, const Parameters& parameters) {
  Stages stages;
  stages.luma = lens_ ? lens_->rectify(luma(image)) : luma(image);
  stages.pairs = ring_.pair(stages.luma, parameters.homography, parameters.replace_reference);
  stages.difference = difference(stages.pairs);
  stages.motion = displacement(stages.difference, stages.pairs.gradient, parameters.displacement);
  stages.blurred = gaussian(stages.difference);
  stages.high_threshold = high_threshold(parameters.threshold, otsu_threshold_);
  stages.otsu_threshold = otsu_threshold_ = otsu(stages.blurred);
  stages.binary = binarize(stages.blurred, stages.high_threshold, parameters.threshold.low);
  stages.eroded = parameters.erode_high ? erode(stages.binary) : stages.binary;
  stages.region = roi(stages.eroded, parameters.roi_first_row, parameters.roi_last_row);
  stages.histogram = polar(stages.region, stages.motion, parameters.lines, parameters.rule);
  stages.points = birdseye(stages.histogram.contacts, parameters.birdseye);
  stages.obstacles = cluster(stages.points, parameters.cluster_gap_m, parameters.min_lines);
  return stages;
}

}  // namespace floorline::golden
