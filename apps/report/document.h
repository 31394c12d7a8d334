/// What a report shows, as plain data. The commands fill it in; write_html() turns it into one page that
/// needs nothing else. Metres and radians; the world is the odometry frame, the robot frame is X forward, Y
/// left (docs/architecture.md).
#ifndef FLOORLINE_APPS_REPORT_DOCUMENT_H
#define FLOORLINE_APPS_REPORT_DOCUMENT_H

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "figure.h"

namespace floorline::report {

using Polyline = std::vector<Eigen::Vector2d>;

/// A stage of the pipeline as the report names it. What it compares is in each frame's StagePictures.
struct Stage {
  std::string name;          ///< Kernel name, as in hls/NAME.h.
  std::string description;   ///< One sentence: what the pictures show.
  double amplification = 1;  ///< Factor on the difference pictures.
  std::vector<Figure> figures;
};

/// One stage in one frame. Pictures are CV_8UC1 or CV_8UC3, all three of one size; encoding happens in
/// write_html().
struct StagePictures {
  cv::Mat kernel;
  cv::Mat golden;
  cv::Mat difference;   ///< Already amplified; black where both agree.
  std::string caption;  ///< How far they are apart in this frame, for example "identical".
};

/// A contact point in pixels of the camera image.
struct ContactMark {
  double u = 0, v = 0;
  bool clipped = false;
};

/// An obstacle's foot as the ground truth knows it, in the robot frame of the frame.
struct TrueFoot {
  std::string kind;
  Polyline contact;
};

/// One frame of the slider.
struct Frame {
  int index = 0;  ///< Number in the sequence.
  double timestamp_s = 0;
  cv::Mat camera;                     ///< The image that the contact points are drawn on.
  std::vector<StagePictures> stages;  ///< In the order of Document::stages; may be empty.
  std::vector<ContactMark> kernel_contacts;
  std::vector<ContactMark> golden_contacts;
  Eigen::Vector3d pose = Eigen::Vector3d::Zero();  ///< x, y, yaw in the world.
  std::vector<Eigen::Vector2d> points;             ///< Contact points on the floor, robot frame.
  std::vector<Eigen::Vector2d> obstacles;          ///< Clustered reports, robot frame.
  std::vector<TrueFoot> truth;
  std::vector<Polyline> markings;                             ///< Flat polygons on the floor, robot frame.
  std::vector<std::pair<std::string, std::string>> readings;  ///< Small facts: threshold, contact count ...
};

/// A line of the polar walk between its end points, pixels.
struct WalkLine {
  double u0, v0, u1, v1;
};

/// Occupancy grid: CV_8UC1 picture with row 0 at the greatest Y, column 0 at the least X of the world.
struct Grid {
  cv::Mat picture;
  double resolution_m = 0.05;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< World position of the lower left corner.
};

/// Equal bins over [low, high]; values outside count in the first and last bin.
struct Histogram {
  std::string title;
  std::string unit;
  double low = 0, high = 1;
  std::vector<int> counts;
  std::string note;  ///< For example the median.
};

struct Table {
  std::string title;
  std::string note;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

struct Parameter {
  std::string name, value, meaning;
};

/// The whole report.
struct Document {
  std::string title;
  std::string subtitle;
  int image_width = 0, image_height = 0;
  std::vector<Figure> headline;  ///< Tiles at the top.
  std::vector<Figure> figures;   ///< Verdict and the first table.
  std::vector<Stage> stages;
  std::vector<Frame> frames;
  std::vector<WalkLine> lines;
  std::vector<Eigen::Vector3d> path;  ///< Pose of every frame of the sequence, x, y, yaw in the world.
  Polyline field_of_view;             ///< Floor that the camera sees, robot frame, closed.
  std::vector<Grid> grids;            ///< None or one.
  std::vector<Histogram> histograms;
  std::vector<Table> tables;
  std::vector<Parameter> parameters;
  nlohmann::json hardware =
      nlohmann::json::array();  ///< Sections of docs/report.md, checked by read_hardware().
};

/// Sorts `values` into `bins` equal bins; the note tells the count, median and greatest value.
Histogram make_histogram(const std::string& title, const std::string& unit, const std::vector<double>& values,
                         double low, double high, int bins);

}  // namespace floorline::report

#endif
