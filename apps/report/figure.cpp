#include "figure.h"

#include <fmt/format.h>

#include <cmath>

namespace floorline::report {
namespace {

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() || !std::isfinite(value) ? format_value(value) : format_value(value) + " " + unit;
}

}  // namespace

std::string format_value(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "none";
}

std::string Figure::bound_text() const {
  return (relation == Relation::at_least ? ">= " : "<= ") + with_unit(bound, unit);
}

std::string Figure::value_text() const { return with_unit(value, unit); }

nlohmann::json to_json(const Figure& figure) {
  return {{"name", figure.name},
          {"label", figure.label},
          {"value", std::isfinite(figure.value) ? nlohmann::json(figure.value) : nlohmann::json(nullptr)},
          {"bound", figure.bound_text()},
          {"unit", figure.unit},
          {"verdict", figure.ok() ? "ok" : "short"}};
}

}  // namespace floorline::report
