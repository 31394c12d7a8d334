/// Pictures as data URIs.
#ifndef FLOORLINE_APPS_REPORT_IMAGE_URI_H
#define FLOORLINE_APPS_REPORT_IMAGE_URI_H

#include <opencv2/core.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace floorline::report {

/// `bytes` in base 64 behind "data:TYPE;base64,".
std::string data_uri(std::string_view media_type, const std::vector<unsigned char>& bytes);

/// CV_8UC1 or CV_8UC3 as WebP: every pixel exact, for masks, differences and grids.
std::string lossless_uri(const cv::Mat& picture);

/// CV_8UC1 or CV_8UC3 as WebP of quality 80, for camera images.
std::string photograph_uri(const cv::Mat& picture);

}  // namespace floorline::report

#endif
