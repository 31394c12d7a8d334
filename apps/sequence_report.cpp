#include "sequence_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <set>

#include "check.h"
#include "host/grid.h"
#include "render/truth.h"
#include "score.h"
#include "settings_file.h"

namespace floorline::app {
namespace {

using Eigen::Vector2d;

/// How the report shows an image stage.
struct StageView {
  const char* description;
  double gain;           ///< On the kernel and golden pictures: differences are dim.
  double amplification;  ///< On their difference.
};

constexpr StageView stage_views[kImageStages] = {
    {"Brightness of the camera image.", 1, 64},
    {"The reference frame as the floor homography says it should look now.", 1, 8},
    {"What the floor does not explain: |warped reference - current|, shown × 4.", 4, 64},
    {"Motion against the floor. White moves, grey stirs, black rests: a foot is black, its obstacle grey or "
     "white.",
     1, 1},
    {"The difference after the Gaussian 3×3, shown × 4.", 4, 64},
    {"Two thresholds: high bit white, low bit blue.", 1, 85},
    {"Erosion of the high bit, where the settings ask for it.", 1, 85},
    {"Rows of interest, below the horizon.", 1, 85}};

bool is_mask(int stage) { return stage >= static_cast<int>(ImageStage::binarize); }

/// Masks in three colours; other stages with their gain.
cv::Mat stage_picture(const cv::Mat& image, int stage) {
  if (!is_mask(stage)) return image * stage_views[stage].gain;
  cv::Mat colours(1, 256, CV_8UC3, cv::Scalar(235, 235, 235));
  colours.at<cv::Vec3b>(0) = {18, 15, 14};
  colours.at<cv::Vec3b>(1) = {140, 88, 46};
  cv::Mat bgr, picture;
  cv::cvtColor(image, bgr, cv::COLOR_GRAY2BGR);
  cv::LUT(bgr, colours, picture);
  return picture;
}

report::StagePictures stage_pictures(const StagePair& pair, int stage) {
  cv::Mat difference;
  cv::absdiff(pair.kernel, pair.golden, difference);
  const int differing = cv::countNonZero(difference);
  const StageBound& bound = stage_bounds()[stage];
  const std::string caption =
      differing == 0 ? "identical"
                     : fmt::format("{} pixels differ, worst {:.2g} {}", differing, pair.worst, bound.unit);
  return {stage_picture(pair.kernel, stage), stage_picture(pair.golden, stage),
          difference * stage_views[stage].amplification, caption};
}

/// Without erosion that kernel passes its input on, which is not worth a row.
std::vector<int> shown_stages(const Settings& settings) {
  std::vector<int> stages;
  for (int stage = 0; stage < kImageStages; ++stage) {
    if (stage != static_cast<int>(ImageStage::erode) || settings.erode) stages.push_back(stage);
  }
  return stages;
}

std::vector<report::Stage> describe_stages(const std::vector<int>& shown,
                                           const std::vector<report::Figure>& figures) {
  std::vector<report::Stage> stages;
  for (const int i : shown)
    stages.push_back({std::string(stage_bounds()[i].name),
                      stage_views[i].description,
                      stage_views[i].amplification,
                      {figures[i]}});
  return stages;
}

/// Frames of the slider: spread evenly over those with a mature baseline, or over all when there is none.
std::set<int> chosen_frames(const Drive& drive, int most) {
  ReferencePlan plan = drive.configuration().reference_plan();
  std::vector<int> candidates;
  for (int i = 0; i < drive.frame_count(); ++i) {
    if (plan.next(drive.world_from_robot()[i]).mature) candidates.push_back(i);
  }
  for (int i = 0; candidates.empty() && i < drive.frame_count(); ++i) candidates.push_back(i);
  const int count = std::min<int>(most, static_cast<int>(candidates.size()));
  std::set<int> chosen;
  for (int k = 0; k < count; ++k) chosen.insert(candidates[(2 * k + 1) * candidates.size() / (2 * count)]);
  return chosen;
}

Vector2d floor_place(const cv::Matx33d& birdseye, double u, double v) {
  const cv::Vec3d place = birdseye * cv::Vec3d(u, v, 1);
  return {place[0] / place[2], place[1] / place[2]};
}

/// Floor farther away than this is not shown: rows near the horizon see very far.
double shown_range(const Drive& drive) { return 8 * drive.sequence().robot_from_camera().translation().z(); }

/// The floor in the region of interest, closed: along the last row to the right, then back along the far
/// side.
report::Polyline field_of_view(const Drive& drive) {
  constexpr int steps = 24;
  const cv::Rect roi = drive.configuration().roi();
  const cv::Matx33d birdseye = drive.configuration().golden_parameters({}).birdseye;
  const int last = roi.br().y - 1;
  report::Polyline outline = {floor_place(birdseye, 0, last), floor_place(birdseye, roi.width - 1, last)};
  for (int step = steps; step >= 0; --step) {
    const double u = (roi.width - 1) * static_cast<double>(step) / steps;
    int row = last;
    while (row > roi.y && floor_place(birdseye, u, row - 1).norm() < shown_range(drive)) --row;
    outline.push_back(floor_place(birdseye, u, row));
  }
  return outline;
}

std::vector<report::ContactMark> marks(const Finding& finding) {
  std::vector<report::ContactMark> result;
  for (const golden::FloorPoint& point : finding.points)
    result.push_back(
        {static_cast<double>(point.contact.u), static_cast<double>(point.contact.v), point.contact.clipped});
  return result;
}

Eigen::Vector3d planar_vector(const Eigen::Isometry3d& world_from_robot) {
  const PlanarPose pose = planar(world_from_robot);
  return {pose.x_m, pose.y_m, pose.yaw_rad};
}

void add_findings(report::Frame& shown, const CheckedFrame& frame, double range) {
  shown.kernel_contacts = marks(frame.kernel);
  shown.golden_contacts = marks(frame.golden);
  for (const golden::FloorPoint& point : frame.kernel.points) {
    const Vector2d place(point.x, point.y);
    if (!point.contact.clipped && place.norm() < range) shown.points.push_back(place);
  }
  for (const golden::Obstacle& obstacle : frame.kernel.obstacles) {
    const Vector2d place(obstacle.nearest.x, obstacle.nearest.y);
    if (!obstacle.nearest.contact.clipped && place.norm() < range) shown.obstacles.push_back(place);
  }
}

void add_truth(report::Frame& shown, const render::TrueFrame& truth) {
  for (const render::TrueObstacle& obstacle : truth.obstacles) {
    for (const render::Polyline& piece : obstacle.contact) shown.truth.push_back({obstacle.kind, piece});
  }
  for (const render::Polyline& wall : truth.walls) shown.truth.push_back({"wall", wall});
  shown.markings = truth.markings;
}

void add_readings(report::Frame& shown, const CheckedFrame& frame) {
  const PlannedFrame& plan = frame.input.plan;
  const double pixels = static_cast<double>(frame.input.image.total());
  shown.readings = {{"obstacles", std::to_string(frame.kernel.obstacles.size())},
                    {"contact points", std::to_string(frame.kernel.points.size())},
                    {"high threshold", std::to_string(frame.high_threshold)},
                    {"null pixels", fmt::format("{:.1f} %", 100 * frame.null_pixels / pixels)}};
  if (plan.reference >= 0) {
    shown.readings.push_back({"baseline", fmt::format("{} frames", frame.input.index - plan.reference)});
    shown.readings.push_back({"parallax", fmt::format("{:.2g} px", plan.parallax_px)});
  }
}

report::Frame shown_frame(const CheckedFrame& frame, const std::vector<int>& stages, double range) {
  report::Frame shown;
  shown.index = frame.input.index;
  shown.timestamp_s = frame.input.timestamp_s;
  shown.camera = frame.input.image;
  shown.pose = planar_vector(frame.input.world_from_robot);
  for (const int stage : stages) shown.stages.push_back(stage_pictures(frame.stages[stage], stage));
  add_findings(shown, frame, range);
  add_readings(shown, frame);
  return shown;
}

/// The grid as a picture over the places where the robot has been and what it can see from there.
report::Grid grid_picture(const Grid& grid, const Drive& drive) {
  constexpr double resolution_m = 0.05;
  const double range = shown_range(drive);
  Vector2d low = Vector2d::Constant(INFINITY), high = -low;
  for (const Eigen::Isometry3d& pose : drive.world_from_robot()) {
    low = low.cwiseMin(pose.translation().head<2>());
    high = high.cwiseMax(pose.translation().head<2>());
  }
  low.array() -= range;
  high.array() += range;
  const Eigen::Vector2i cells = ((high - low) / resolution_m).array().ceil().cast<int>();
  report::Grid shown{cv::Mat(cells.y(), cells.x(), CV_8UC1), resolution_m, low};
  for (int row = 0; row < cells.y(); ++row) {
    for (int column = 0; column < cells.x(); ++column) {
      const Vector2d place = low + resolution_m * Vector2d(column + 0.5, cells.y() - row - 0.5);
      shown.picture.at<uchar>(row, column) = cv::saturate_cast<uchar>(255 * (1 - grid.occupancy(place)));
    }
  }
  return shown;
}

/// Only the part of the grid where something is known.
report::Grid trimmed(const report::Grid& grid) {
  const cv::Rect known = cv::boundingRect(grid.picture != 127 & grid.picture != 128);
  if (known.empty()) return grid;
  const int rows_below = grid.picture.rows - known.br().y;
  return {grid.picture(known).clone(), grid.resolution_m,
          grid.origin + grid.resolution_m * Vector2d(known.x, rows_below)};
}

std::vector<std::string> score_row(const std::string& rule, const std::string& evidence,
                                   const render::Score& score) {
  const auto share = [](double value) { return report::format_value(value, 3); };
  return {rule,
          evidence,
          share(score.recall()),
          share(score.precision()),
          share(score.median_error_m()),
          share(score.duplicate_share()),
          share(score.marking_share())};
}

/// Our rule beside the paper's on the same sequence.
report::Table detection_table(const DetectionScore& ours, const DetectionScore& paper) {
  return {"Detection",
          "Obstacles within 4 m and higher than 10 cm, against the exact ground truth. The paper's rule: S_c "
          "> 4 on Otsu's threshold, no "
          "baseline control, no clustering.",
          {"rule", "", "recall", "precision", "median error, m", "duplicates", "markings reported"},
          {score_row("ours", "each frame", ours.per_frame),
           score_row("ours", "confirmed in the grid", ours.confirmed),
           score_row("paper", "each frame", paper.per_frame)}};
}

report::Table mask_table(const DetectionScore& ours, const DetectionScore& paper) {
  const auto row = [](const std::string& rule, const DetectionScore& score) -> std::vector<std::string> {
    return {rule, report::format_value(score.pixels.recall(), 3),
            report::format_value(score.pixels.precision(), 3),
            report::format_value(score.mask.precision(), 3)};
  };
  return {
      "Against the obstacle mask",
      "Pixels of the high mask in the region of interest, and contact points that lie at an obstacle's foot.",
      {"rule", "pixel recall", "pixel precision", "contact points at a foot"},
      {row("ours", ours), row("paper", paper)}};
}

DetectionScore scored(const ReportRequest& request, const Settings& settings, const char* task) {
  Drive drive(request.sequence, settings, request.poses);
  const std::unique_ptr<Model> model = csim_model(drive, true);
  return score(drive, *model, task);
}

/// The paper's rule, looking where the settings look.
Settings paper_for(const Settings& settings) {
  Settings paper = paper_settings();
  paper.line_count = settings.line_count;
  paper.roi_margin_rows = settings.roi_margin_rows;
  return paper;
}

void add_scores(report::Document& document, const ReportRequest& request) {
  const DetectionScore ours = scored(request, request.settings, "score");
  const DetectionScore paper = scored(request, paper_for(request.settings), "score the paper's rule");
  for (const report::Figure& figure : score_figures(ours)) {
    document.figures.push_back(figure);
    document.headline.push_back(figure);
  }
  if (ours.has_contacts) {
    document.tables.push_back(detection_table(ours, paper));
    document.histograms.push_back(report::make_histogram("Distance of reports from the true foot, within 3 m",
                                                         "m", ours.per_frame.errors_m, 0, 0.15, 30));
  }
  document.tables.push_back(mask_table(ours, paper));
}

/// One tile for all kernels, one for the whole pipeline, which is the last figure.
std::vector<report::Figure> check_headline(const std::vector<report::Figure>& figures) {
  const auto kernels = static_cast<double>(figures.size() - 1);
  const auto kept = static_cast<double>(
      std::count_if(figures.begin(), figures.end() - 1, [](const auto& figure) { return figure.ok(); }));
  return {{"kernels", "kernels that keep their bound against golden", kept, report::Relation::at_least,
           kernels, ""},
          figures.back()};
}

/// Everything that needs the frames themselves: pictures, marks, map, figures of the check.
void add_check(report::Document& document, Drive& drive, const ReportRequest& request) {
  const std::set<int> chosen = chosen_frames(drive, request.frames);
  const std::vector<int> stages = shown_stages(request.settings);
  const double range = 1.5 * shown_range(drive);
  std::vector<render::TrueFrame> truth;
  if (const auto folder = drive.sequence().truth_folder();
      folder && std::filesystem::exists(*folder / "contacts.json"))
    truth = render::read_truth(*folder / "contacts.json");
  Grid grid{GridSettings{}};
  const CheckResult result = check(drive, [&](const CheckedFrame& frame) {
    grid.add(planar(frame.input.world_from_robot), floor_rays(frame.input.golden, frame.kernel.points),
             frame.input.plan.parallax_px);
    if (chosen.count(frame.input.index) == 0) return;
    document.frames.push_back(shown_frame(frame, stages, range));
    if (!truth.empty()) add_truth(document.frames.back(), truth.at(frame.input.index));
  });
  document.figures = result.figures;
  document.headline = check_headline(result.figures);
  document.stages = describe_stages(stages, result.figures);
  document.grids = {trimmed(grid_picture(grid, drive))};
  document.histograms.push_back(report::make_histogram("Contact points, kernels against golden", "px",
                                                       result.contact_distances, 0, 4, 16));
}

std::string subtitle(const Drive& drive, const Settings& settings) {
  const Sequence& sequence = drive.sequence();
  const std::string baseline = settings.reference.every > 0
                                   ? fmt::format("{} frames", settings.reference.every)
                                   : std::string("as odometry asks");
  return fmt::format("{} frames of {} × {}, {} · rule: {} · baseline: {}", drive.frame_count(),
                     sequence.camera().size.width, sequence.camera().size.height, sequence.info().source,
                     settings.rule == golden::Rule::run ? "run" : "paper", baseline);
}

}  // namespace

report::Document make_document(const ReportRequest& request) {
  Drive drive(request.sequence, request.settings, request.poses);
  report::Document document;
  document.title = drive.sequence().info().name;
  document.subtitle = subtitle(drive, request.settings);
  document.image_width = drive.sequence().camera().size.width;
  document.image_height = drive.sequence().camera().size.height;
  document.field_of_view = field_of_view(drive);
  for (const Eigen::Isometry3d& pose : drive.world_from_robot()) document.path.push_back(planar_vector(pose));
  for (const golden::Line& line : drive.configuration().golden_parameters({}).lines)
    document.lines.push_back({static_cast<double>(line.first.x), static_cast<double>(line.first.y),
                              static_cast<double>(line.last.x), static_cast<double>(line.last.y)});
  add_check(document, drive, request);
  if (drive.sequence().truth_folder()) add_scores(document, request);
  document.parameters = describe(request.settings);
  return document;
}

}  // namespace floorline::app
