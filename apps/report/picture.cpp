#include "picture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace floorline::report {
namespace {

// Everything is drawn at twice its size and shrunk at the end, so that edges and letters come out smooth.
constexpr int kScale = 2;
constexpr int kMargin = 18 * kScale;
constexpr int kPanelHeight = 375 * kScale;
constexpr int kMapWidth = 400 * kScale;
constexpr int kCaption = 34 * kScale;

// Colours of page.css, light scheme, as B G R.
const cv::Scalar kGround(247, 250, 251), kCard(255, 255, 255), kInk(40, 35, 31), kQuiet(120, 112, 106),
    kRule(219, 225, 227);
const cv::Scalar kKernel(12, 89, 232), kTruth(91, 158, 47), kRobot(196, 61, 95), kView(252, 244, 247);

void text(cv::Mat& canvas, const std::string& words, cv::Point at, double size, const cv::Scalar& colour) {
  cv::putText(canvas, words, at, cv::FONT_HERSHEY_SIMPLEX, size * kScale, colour, kScale, cv::LINE_AA);
}

void dot(cv::Mat& canvas, cv::Point2d at, double radius, const cv::Scalar& colour, const cv::Scalar& rim) {
  const cv::Point centre(cvRound(at.x), cvRound(at.y));
  cv::circle(canvas, centre, cvRound((radius + 1) * kScale), rim, cv::FILLED, cv::LINE_AA);
  cv::circle(canvas, centre, cvRound(radius * kScale), colour, cv::FILLED, cv::LINE_AA);
}

cv::Mat fitted(const cv::Mat& picture) {
  cv::Mat colour, scaled;
  if (picture.channels() == 1)
    cv::cvtColor(picture, colour, cv::COLOR_GRAY2BGR);
  else
    colour = picture;
  cv::resize(colour, scaled, cv::Size(picture.cols * kPanelHeight / picture.rows, kPanelHeight), 0, 0,
             cv::INTER_CUBIC);
  return scaled;
}

cv::Mat camera_panel(const Frame& frame) {
  cv::Mat panel = fitted(frame.camera);
  const double scale = static_cast<double>(kPanelHeight) / frame.camera.rows;
  for (const ContactMark& mark : frame.kernel_contacts)
    dot(panel, {(mark.u + 0.5) * scale, (mark.v + 0.5) * scale}, 3, kKernel, cv::Scalar::all(20));
  return panel;
}

/// The floor around the robot: X of the robot frame points up. Covers the field of view.
class MapPanel {
 public:
  explicit MapPanel(const Polyline& field_of_view) {
    for (const auto& point : field_of_view)
      reach_ = std::max({reach_, point.x(), 1.25 * std::abs(point.y())});
    scale_ = kPanelHeight / (1.16 * reach_);
    panel_ = cv::Mat(kPanelHeight, kMapWidth, CV_8UC3, kCard);
  }

  cv::Mat draw(const Frame& frame, const Polyline& field_of_view) {
    cv::fillPoly(panel_, std::vector<std::vector<cv::Point>>{pixels(field_of_view)}, kView, cv::LINE_AA);
    draw_axes();
    for (const TrueFoot& foot : frame.truth)
      cv::polylines(panel_, pixels(foot.contact), false, kTruth, 3 * kScale, cv::LINE_AA);
    for (const auto& point : frame.obstacles) dot(panel_, pixel(point), 4.5, kKernel, kCard);
    cv::fillPoly(panel_, std::vector<std::vector<cv::Point>>{robot()}, kRobot, cv::LINE_AA);
    return panel_;
  }

 private:
  cv::Point2d pixel(const Eigen::Vector2d& point) const {
    return {kMapWidth / 2 - point.y() * scale_, kPanelHeight - (point.x() + 0.09 * reach_) * scale_};
  }

  std::vector<cv::Point> pixels(const Polyline& line) const {
    std::vector<cv::Point> result;
    for (const auto& point : line) result.emplace_back(pixel(point));
    return result;
  }

  std::vector<cv::Point> robot() const {
    const cv::Point at(pixel({0, 0}));
    const int k = kScale;
    return {at + cv::Point(0, -9 * k), at + cv::Point(7 * k, 8 * k), at + cv::Point(0, 4 * k),
            at + cv::Point(-7 * k, 8 * k)};
  }

  void draw_axes() {
    const int step = reach_ > 12 ? 10 : 1;
    for (int metre = step; metre < 1.05 * reach_; metre += step) {
      const int row = cvRound(pixel({static_cast<double>(metre), 0}).y);
      cv::line(panel_, {0, row}, {kMapWidth, row}, kRule, kScale);
      text(panel_, std::to_string(metre) + " m", {8 * kScale, row - 5 * kScale}, 0.38, kQuiet);
    }
  }

  double reach_ = 0.5;
  double scale_;
  cv::Mat panel_;
};

cv::Mat beside(const std::vector<std::pair<cv::Mat, std::string>>& panels) {
  int width = kMargin;
  for (const auto& [panel, caption] : panels) width += panel.cols + kMargin;
  cv::Mat canvas(kPanelHeight + kMargin + kCaption, width, CV_8UC3, kGround);
  int x = kMargin;
  for (const auto& [panel, caption] : panels) {
    const cv::Rect place(x, kMargin, panel.cols, panel.rows);
    panel.copyTo(canvas(place));
    cv::rectangle(canvas, place, kRule, kScale);
    text(canvas, caption, {x, kMargin + kPanelHeight + 22 * kScale}, 0.45, kInk);
    x += panel.cols + kMargin;
  }
  return canvas;
}

}  // namespace

std::size_t liveliest_frame(const Document& document) {
  std::size_t most = 0;
  for (const Frame& frame : document.frames) most = std::max(most, frame.obstacles.size());
  std::vector<std::size_t> best;
  for (std::size_t i = 0; i < document.frames.size(); ++i) {
    if (document.frames[i].obstacles.size() == most) best.push_back(i);
  }
  return best[best.size() / 2];
}

cv::Mat compose_picture(const Document& document, std::size_t frame_index, const std::string& stage) {
  const auto found = std::find_if(document.stages.begin(), document.stages.end(),
                                  [&](const Stage& candidate) { return candidate.name == stage; });
  if (found == document.stages.end()) throw std::logic_error("the report has no stage named " + stage);
  const Frame& frame = document.frames.at(frame_index);
  const cv::Mat middle = frame.stages.at(found - document.stages.begin()).kernel;
  const cv::Mat canvas = beside({{camera_panel(frame), "camera, contact points of the kernels"},
                                 {fitted(middle), "what the floor does not explain"},
                                 {MapPanel(document.field_of_view).draw(frame, document.field_of_view),
                                  "floor: reports (orange), truth (green)"}});
  cv::Mat picture;
  cv::resize(canvas, picture, canvas.size() / kScale, 0, 0, cv::INTER_AREA);
  return picture;
}

}  // namespace floorline::report
