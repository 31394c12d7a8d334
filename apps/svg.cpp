#include "svg.h"

#include <fmt/format.h>

namespace floorline::app::svg {

std::string picture(int width, int height, const std::string& body) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "font-family=\"sans-serif\" font-size=\"12\" fill=\"#888\">{2}</svg>\n",
      width, height, body);
}

std::string label(int x, int y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>", x, y, anchor, text);
}

std::string box(int x, int y, int width, int height, const std::string& colour) {
  return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>", x, y, width, height,
                     colour);
}

std::string line(const std::string& points, const std::string& colour) {
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>", points,
                     colour);
}

}  // namespace floorline::app::svg
