/// Golden twin of hls/otsu.h.
#ifndef FLOORLINE_GOLDEN_OTSU_H
#define FLOORLINE_GOLDEN_OTSU_H

#include <opencv2/core.hpp>

namespace floorline::golden {

/// Otsu's threshold (ICVS paper, eq. 9-11): the cut t that maximises the variance between the classes p <= t
/// and p > t. Thresholds between two neighbouring grey levels that occur make the same cut; the lowest of
/// them is returned, so that the answer does not hang on rounding. 0 for an image of a single grey level.
/// `image`: CV_8UC1, not empty.
int otsu(const cv::Mat& image);

}  // namespace floorline::golden

#endif
