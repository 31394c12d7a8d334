/// Frames as the video cores of the vendors stream them.
#ifndef FLOORLINE_TB_COSIM_VIDEO_H
#define FLOORLINE_TB_COSIM_VIDEO_H

#include <deque>
#include <opencv2/core.hpp>

#include "tb/cosim/axi_stream.h"

namespace floorline::cosim {

/// Appends rows [first, end) of a frame (CV_8UC1: grey in 7:0; CV_8UC3: G, B, R from bit 0 on).
void queue_video(const cv::Mat& image, int first, int end, std::deque<VideoBeat>& queue);

}  // namespace floorline::cosim

#endif
