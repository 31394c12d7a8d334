#include "html.h"

#include <fmt/format.h>

#include <opencv2/imgproc.hpp>

#include "image_uri.h"
#include "page.h"

namespace floorline::report {
namespace {

using nlohmann::json;

/// Size on the page.
cv::Size fitted(cv::Size size) {
  return size.width <= kPictureWidth ? size
                                     : cv::Size(kPictureWidth, size.height * kPictureWidth / size.width);
}

cv::Mat shrunk(const cv::Mat& picture, cv::InterpolationFlags interpolation) {
  cv::Mat small;
  cv::resize(picture, small, fitted(picture.size()), 0, 0, interpolation);
  return small;
}

std::string photograph(const cv::Mat& picture) { return photograph_uri(shrunk(picture, cv::INTER_AREA)); }

/// Grey pictures are photographs; coloured ones are masks, whose few colours must stay what they are.
std::string stage_picture(const cv::Mat& picture) {
  return picture.channels() == 1 ? photograph(picture) : lossless_uri(shrunk(picture, cv::INTER_NEAREST));
}

/// Spreads the maximum before it shrinks, so that a lone different pixel stays visible.
std::string difference_picture(const cv::Mat& difference) {
  const int reach = (difference.cols + kPictureWidth - 1) / kPictureWidth;
  cv::Mat spread;
  cv::dilate(difference, spread, cv::Mat::ones(reach, reach, CV_8U));
  return lossless_uri(shrunk(spread, cv::INTER_NEAREST));
}

/// ">= 0.9" as people write it: "≥ 0.9".
std::string typographic(std::string bound) { return bound.replace(0, 2, bound[0] == '>' ? "≥" : "≤"); }

/// The JSON that page.js reads, part by part. A struct, so that each part can name every other.
struct PageData {
  static json of(const Eigen::Vector2d& point) { return {point.x(), point.y()}; }
  static json of(const Eigen::Vector3d& pose) { return {pose.x(), pose.y(), pose.z()}; }
  static json of(const ContactMark& mark) { return {mark.u, mark.v, mark.clipped ? 1 : 0}; }
  static json of(const WalkLine& line) { return {line.u0, line.v0, line.u1, line.v1}; }
  static json of(const std::pair<std::string, std::string>& reading) {
    return {reading.first, reading.second};
  }

  template <typename Items>
  static json list(const Items& items) {
    json array = json::array();
    for (const auto& item : items) array.push_back(of(item));
    return array;
  }

  static json of(const Polyline& polyline) { return list<Polyline>(polyline); }
  static json of(const TrueFoot& foot) { return {{"kind", foot.kind}, {"contact", of(foot.contact)}}; }

  static json of(const StagePictures& pictures) {
    return {{"kernel", stage_picture(pictures.kernel)},
            {"golden", stage_picture(pictures.golden)},
            {"difference", difference_picture(pictures.difference)},
            {"caption", pictures.caption}};
  }

  static json of(const Frame& frame) {
    return {{"index", frame.index},
            {"timestamp", frame.timestamp_s},
            {"camera", photograph(frame.camera)},
            {"stages", list(frame.stages)},
            {"kernelContacts", list(frame.kernel_contacts)},
            {"goldenContacts", list(frame.golden_contacts)},
            {"pose", of(frame.pose)},
            {"points", list(frame.points)},
            {"obstacles", list(frame.obstacles)},
            {"truth", list(frame.truth)},
            {"markings", list(frame.markings)},
            {"readings", list(frame.readings)}};
  }

  static json of(const Stage& stage) {
    return {{"name", stage.name},
            {"description", stage.description},
            {"amplification", stage.amplification},
            {"figures", list(stage.figures)}};
  }

  static json of(const Figure& figure) {
    return {{"label", figure.label},
            {"value", figure.value_text()},
            {"bound", typographic(figure.bound_text())},
            {"verdict", figure.ok() ? "ok" : "short"}};
  }

  static json of(const Grid& grid) {
    return {{"picture", lossless_uri(grid.picture)},
            {"origin", of(grid.origin)},
            {"width", grid.picture.cols * grid.resolution_m},
            {"height", grid.picture.rows * grid.resolution_m}};
  }

  static json of(const Histogram& histogram) {
    return {{"title", histogram.title}, {"unit", histogram.unit},     {"low", histogram.low},
            {"high", histogram.high},   {"counts", histogram.counts}, {"note", histogram.note}};
  }

  static json of(const Table& table) {
    return {{"title", table.title}, {"note", table.note}, {"columns", table.columns}, {"rows", table.rows}};
  }

  static json of(const Parameter& parameter) { return {parameter.name, parameter.value, parameter.meaning}; }

  static json of(const Document& document) {
    return {{"title", document.title},
            {"subtitle", document.subtitle},
            {"width", document.image_width},
            {"height", document.image_height},
            {"headline", list(document.headline)},
            {"figures", list(document.figures)},
            {"stages", list(document.stages)},
            {"frames", list(document.frames)},
            {"lines", list(document.lines)},
            {"path", list(document.path)},
            {"fieldOfView", of(document.field_of_view)},
            {"grids", list(document.grids)},
            {"histograms", list(document.histograms)},
            {"tables", list(document.tables)},
            {"parameters", list(document.parameters)},
            {"hardware", document.hardware}};
  }
};

/// JSON that can stand inside a script element: no "</" may occur there.
std::string script_safe(const json& data) {
  std::string text = data.dump(-1, ' ', false, json::error_handler_t::replace);
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3))
    text.insert(at + 1, "\\");
  return text;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '&')
      safe += "&amp;";
    else
      safe += c;
  }
  return safe;
}

}  // namespace

std::string to_html(const Document& document) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\">\n<title>{}</title>\n<style>\n{}</style>\n"
      "</head>\n<body>\n<noscript>This report draws itself with JavaScript; allow it for this "
      "file.</noscript>\n"
      "<script type=\"application/json\" "
      "id=\"report-data\">{}</script>\n<script>\n{}</script>\n</body>\n</html>\n",
      escaped(document.title), page_style, script_safe(PageData::of(document)), page_script);
}

}  // namespace floorline::report
