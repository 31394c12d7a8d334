/// Figures as text and JSON, the same for check and score.
#ifndef FLOORLINE_APPS_FIGURE_TABLE_H
#define FLOORLINE_APPS_FIGURE_TABLE_H

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/figure.h"

namespace floorline::app {

/// A line a figure: label, value, bound, verdict, in columns; without a newline at the end.
std::string figure_table(const std::vector<report::Figure>& figures);

nlohmann::json to_json(const std::vector<report::Figure>& figures);

}  // namespace floorline::app

#endif
