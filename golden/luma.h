/// Golden twin of hls/luma.h: one byte of brightness a pixel.
#ifndef FLOORLINE_GOLDEN_LUMA_H
#define FLOORLINE_GOLDEN_LUMA_H

#include <opencv2/core.hpp>

namespace floorline::golden {

/// Y = 0.299 R + 0.587 G + 0.114 B in floating point, rounded to the nearest. `image`: CV_8UC3 in OpenCV's
/// order B G R, or CV_8UC1, which passes unchanged. Returns CV_8UC1 of the same size.
cv::Mat luma(const cv::Mat& image);

}  // namespace floorline::golden

#endif
