/// A Document as one self-contained HTML page: style, script and pictures are inside, nothing is fetched.
#ifndef FLOORLINE_APPS_REPORT_HTML_H
#define FLOORLINE_APPS_REPORT_HTML_H

#include <string>

#include "document.h"

namespace floorline::report {

/// Pictures wider than this are scaled down: a page of 24 VGA frames with six stages stays below 15 MB.
constexpr int kPictureWidth = 640;

/// Pictures become WebP, masks and differences without loss. Throws std::runtime_error when a picture cannot
/// be encoded.
std::string to_html(const Document& document);

}  // namespace floorline::report

#endif
