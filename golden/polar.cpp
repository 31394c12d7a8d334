#include "golden/polar.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "golden/displacement.h"

namespace floorline::golden {
namespace {

/// A triangle of the paper has S_c above this.
constexpr int triangle_score = 4;
/// Half the window of eq. (17), l.
constexpr int paper_reach = 1;
constexpr int run_reach = 3;
/// Present rows in which a foot does not move.
constexpr int still_rows_of_a_foot = 7;
/// Present rows of an obstacle that at least stir.
constexpr int stirring_rows_of_an_obstacle = 7;

/// Set pixels of `mask` in columns first to last of a row; columns outside the image read 0.
int set_pixels(const cv::Mat& mask, int row, int first, int last) {
  const uchar* pixels = mask.ptr(row);
  int count = 0;
  for (int u = std::max(first, 0); u <= std::min(last, mask.cols - 1); ++u) count += pixels[u] != 0;
  return count;
}

/// eq. (17): a_r around `column`, 0 when the column lies outside the image.
int window_sum(const cv::Mat& mask, int row, int column, int reach) {
  if (column < 0 || column >= mask.cols) return 0;
  return set_pixels(mask, row, column - reach, column + reach);
}

/// What a rule makes of one row of a line.
struct Evidence {
  bool present;  ///< The run begins or goes on.
  int width;     ///< a_high.
  uchar motion;  ///< Against the floor.
};

Evidence look(const Masks& masks, const cv::Mat& motion, const Step& step, Rule rule) {
  const bool inside = step.first_column >= 0 && step.first_column < motion.cols;
  const uchar moved = inside ? motion.at<uchar>(step.row, step.first_column) : rests;
  if (rule == Rule::paper) {
    const int width = window_sum(masks.high, step.row, step.first_column, paper_reach);
    return {width > 0, width, moved};
  }
  return {window_sum(masks.low, step.row, step.first_column, run_reach) > 0,
          window_sum(masks.high, step.row, step.first_column, run_reach), moved};
}

/// A run along a line while it lasts.
class Run {
 public:
  Run(const Step& step) : first_(step), last_(step) {}

  void extend(const Step& step, const Evidence& evidence) {
    high_rows_ += evidence.width > 0;
    score_ = evidence.width <= width_before_ ? score_ + 1 : 0;  // eq. (18)
    width_before_ = evidence.width;
    still_rows_ = evidence.motion == moves ? 0 : still_rows_ + 1;
    stirring_rows_ += evidence.motion != rests;
    last_rests_ = evidence.motion == rests || evidence.motion == unknown_motion;
    last_ = step;
  }

  int gap(int row) const { return row - last_.row; }

  /// The contact that the run is, if it is one. clipped: the line ends before the run does.
  std::optional<Contact> contact(const RuleParameters& rule, bool contact_first, bool clipped) const {
    if (rule.kind == Rule::paper) {
      if (score_ <= triangle_score) return std::nullopt;
      return Contact{.u = last_.first_column, .v = last_.row, .rows = score_, .clipped = clipped};
    }
    const Step& foot = contact_first ? first_ : last_;
    const int rows = last_.row - first_.row + 1;
    const int least_rows =
        std::max(rule.min_rows, cvFloor((foot.row - rule.horizon_row) * rule.height_ratio));
    const bool tall = rows >= least_rows && 3 * high_rows_ >= rows;
    const bool stands = stirring_rows_ >= stirring_rows_of_an_obstacle;
    const bool ends_still = still_rows_ >= still_rows_of_a_foot && last_rests_;
    if (!tall || !stands || !(ends_still || contact_first || clipped)) return std::nullopt;
    return Contact{.u = foot.first_column, .v = foot.row, .rows = rows, .clipped = clipped};
  }

 private:
  Step first_;
  Step last_;
  int high_rows_ = 0;
  int score_ = 0;
  int width_before_ = 0;
  int still_rows_ = 0;     ///< Last present rows that did not move.
  int stirring_rows_ = 0;  ///< Present rows that did not rest.
  bool last_rests_ = false;
};

struct Decision {
  int row;
  Contact contact;
};

/// Walks one line; returns its count of high pixels and appends the contacts with the rows in which they were
/// decided.
int walk_line(const Masks& masks, const cv::Mat& motion, int index, const Line& line,
              const RuleParameters& rule, std::vector<Decision>& decisions) {
  const std::vector<Step> steps = walk(line);
  const int max_gap = rule.kind == Rule::run ? rule.max_gap : 0;
  const int last_row = std::min(steps.back().row, masks.high.rows - 1);
  int count = 0;
  std::optional<Run> run;
  for (const Step& step : steps) {
    if (step.row > last_row) break;
    const auto [left, right] = std::minmax(step.first_column, step.last_column);
    count += set_pixels(masks.high, step.row, left, right);

    const Evidence evidence = look(masks, motion, step, rule.kind);
    if (evidence.present) {
      if (!run) run.emplace(step);
      run->extend(step, evidence);
    }
    const bool gap_ends = run && run->gap(step.row) > max_gap;
    if (!run || !(gap_ends || step.row == last_row)) continue;
    if (std::optional<Contact> contact = run->contact(rule, line.contact_first, !gap_ends)) {
      contact->line = index;
      decisions.push_back({step.row, *contact});
    }
    run.reset();
  }
  return count;
}

}  // namespace

std::vector<Step> walk(const Line& line) {
  std::vector<Step> steps;
  cv::LineIterator pixel(line.first, line.last, 8);
  for (int i = 0; i < pixel.count; ++i, ++pixel) {
    const cv::Point p = pixel.pos();
    if (steps.empty() || steps.back().row != p.y) {
      steps.push_back({p.y, p.x, p.x});
    } else {
      steps.back().last_column = p.x;
    }
  }
  return steps;
}

PolarHistogram polar(const Masks& masks, const cv::Mat& motion, const std::vector<Line>& lines,
                     const RuleParameters& rule) {
  PolarHistogram histogram;
  std::vector<Decision> decisions;
  for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
    histogram.counts.push_back(walk_line(masks, motion, i, lines[i], rule, decisions));
  }
  std::ranges::sort(decisions, {}, [](const Decision& d) { return std::pair(d.row, d.contact.line); });
  for (const Decision& decision : decisions) histogram.contacts.push_back(decision.contact);
  return histogram;
}

}  // namespace floorline::golden
