/// A measured value against its bound: the unit of every verdict, in JSON, text and report alike.
#ifndef FLOORLINE_APPS_REPORT_FIGURE_H
#define FLOORLINE_APPS_REPORT_FIGURE_H

#include <nlohmann/json.hpp>
#include <string>

namespace floorline::report {

enum class Relation { at_least, at_most };

struct Figure {
  std::string name;   ///< Stable key for scripts, for example "gaussian.worst_lsb".
  std::string label;  ///< For people, for example "Gaussian, worst pixel".
  double value = 0;
  Relation relation = Relation::at_most;
  double bound = 0;
  std::string unit;  ///< "px", "m", "LSB", "" for shares.

  /// A value that is not a number is never ok.
  bool ok() const { return relation == Relation::at_least ? value >= bound : value <= bound; }
  std::string bound_text() const;  ///< For example ">= 0.99" or "<= 1 LSB".
  std::string value_text() const;  ///< Four significant digits with the unit.
};

/// Members name, label, value (null when not a number), bound (text), unit, verdict ("ok" or "short").
nlohmann::json to_json(const Figure& figure);

/// Up to `digits` significant digits without trailing zeros: 0.9931, 12, 3.25e-05; "none" for what is not a
/// number.
std::string format_value(double value, int digits = 4);

}  // namespace floorline::report

#endif
