#include "golden/roi.h"

#include <algorithm>

namespace floorline::golden {
namespace {

cv::Mat rows_of(const cv::Mat& mask, int first_row, int last_row) {
  cv::Mat region = cv::Mat::zeros(mask.size(), mask.type());
  const cv::Range rows(std::max(first_row, 0), std::min(last_row, mask.rows - 1) + 1);
  if (rows.start < rows.end) mask.rowRange(rows).copyTo(region.rowRange(rows));
  return region;
}

}  // namespace

Masks roi(const Masks& masks, int first_row, int last_row) {
  return {rows_of(masks.high, first_row, last_row), rows_of(masks.low, first_row, last_row)};
}

}  // namespace floorline::golden
