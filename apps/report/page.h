/// The style and script of the page: page.css and page.js of this folder, embedded by CMake.
#ifndef FLOORLINE_APPS_REPORT_PAGE_H
#define FLOORLINE_APPS_REPORT_PAGE_H

#include <string_view>

namespace floorline::report {

extern const std::string_view page_style;
extern const std::string_view page_script;

}  // namespace floorline::report

#endif
