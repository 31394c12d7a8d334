/// Golden twin of hls/difference.h: what the ground homography does not explain.
#ifndef FLOORLINE_GOLDEN_DIFFERENCE_H
#define FLOORLINE_GOLDEN_DIFFERENCE_H

#include "golden/frame_ring.h"

namespace floorline::golden {

/// |H[I_n] - I_n+1|, CV_8UC1; 0 where the pair is not valid.
cv::Mat difference(const PixelPairs& pairs);

}  // namespace floorline::golden

#endif
