#include "figure_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace floorline::app {

std::string figure_table(const std::vector<report::Figure>& figures) {
  std::size_t width = 0;
  for (const report::Figure& figure : figures) width = std::max(width, figure.label.size());
  std::string table;
  for (const report::Figure& figure : figures) {
    if (!table.empty()) table += '\n';
    table += fmt::format("  {:<{}}  {:>10}  {:<10}  {}", figure.label, width, figure.value_text(),
                         figure.bound_text(), figure.ok() ? "ok" : "short");
  }
  return table;
}

nlohmann::json to_json(const std::vector<report::Figure>& figures) {
  nlohmann::json list = nlohmann::json::array();
  for (const report::Figure& figure : figures) list.push_back(report::to_json(figure));
  return list;
}

}  // namespace floorline::app
