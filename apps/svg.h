/// Small drawings as SVG, in greys and colours that are readable on light and dark.
#ifndef FLOORLINE_APPS_SVG_H
#define FLOORLINE_APPS_SVG_H

#include <string>

namespace floorline::app::svg {

/// What is drawn, where nothing is to be told apart.
constexpr const char* kBlue = "#3b82c4";

/// The whole picture, in pixels; `body` is inside.
std::string picture(int width, int height, const std::string& body);

/// Text at (x, y), its base line; anchor: start, middle or end.
std::string label(int x, int y, const char* anchor, const std::string& text);

/// A filled rectangle.
std::string box(int x, int y, int width, int height, const std::string& colour);

/// A line through `points`, "x,y x,y ...".
std::string line(const std::string& points, const std::string& colour);

}  // namespace floorline::app::svg

#endif
