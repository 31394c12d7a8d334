/// One frame of a report as a single picture, for a README or a slide: camera with contact points,
/// difference, floor map.
#ifndef FLOORLINE_APPS_REPORT_PICTURE_H
#define FLOORLINE_APPS_REPORT_PICTURE_H

#include <opencv2/core.hpp>
#include <string>

#include "document.h"

namespace floorline::report {

/// CV_8UC3, three panels side by side on a light ground. `frame` indexes Document::frames; `stage` names the
/// one whose kernel picture stands in the middle.
cv::Mat compose_picture(const Document& document, std::size_t frame, const std::string& stage);

/// The index of the frame with the most reported obstacles, of those the middle one.
std::size_t liveliest_frame(const Document& document);

}  // namespace floorline::report

#endif
