#include "settings_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include <functional>
#include <string>

#include "host/error.h"
#include "host/text_file.h"

namespace floorline::app {
namespace {

namespace fs = std::filesystem;

/// One key: how to show it and how to set it from a number. Flags are 0 and 1; the rule is 0 for paper, 1 for
/// run.
struct Field {
  enum class Kind { whole, real, flag, rule };
  const char* key;
  Kind kind;
  double low, high;
  const char* meaning;
  std::function<double(const Settings&)> get;
  std::function<void(Settings&, double)> set;
};

/// A field that is a member (of a member) of Settings.
template <typename Access>
Field field(const char* key, Field::Kind kind, double low, double high, const char* meaning, Access access) {
  return {key,
          kind,
          low,
          high,
          meaning,
          [access](const Settings& settings) {
            return static_cast<double>(access(const_cast<Settings&>(settings)));
          },
          [access](Settings& settings, double value) {
            auto& member = access(settings);
            member = static_cast<std::remove_reference_t<decltype(member)>>(value);
          }};
}

#define MEMBER(path) [](Settings& settings) -> auto& { return settings.path; }

const std::vector<Field>& fields() {
  using Kind = Field::Kind;
  static const std::vector<Field> all = {
      field("rule", Kind::rule, 0, 1, "how a run becomes a contact point: run or paper", MEMBER(rule)),
      field("threshold_floor", Kind::whole, 0, 255, "the high threshold is never below this, grey levels",
            MEMBER(threshold.floor)),
      field("threshold_override", Kind::whole, 0, 255, "fixed high threshold instead of Otsu's; 0 for Otsu's",
            MEMBER(threshold.override_high)),
      field("threshold_low", Kind::whole, 0, 255, "low threshold, grey levels", MEMBER(threshold.low)),
      field("min_rows", Kind::whole, 1, 2047, "least rows of a run", MEMBER(min_rows)),
      field("max_gap", Kind::whole, 0, 2047, "rows without a low pixel that a run survives", MEMBER(max_gap)),
      field("least_height_m", Kind::real, 0, 10, "runs shorter than an obstacle of this height are dropped",
            MEMBER(least_height_m)),
      field("erode", Kind::flag, 0, 1, "erosion of the high mask", MEMBER(erode)),
      field("line_count", Kind::whole, 0, 256, "lines of the polar walk", MEMBER(line_count)),
      field("roi_margin_rows", Kind::whole, 0, 2047,
            "rows between the horizon and the first that is looked at", MEMBER(roi_margin_rows)),
      field("cluster_gap_m", Kind::real, 0, 10, "points so near to each other in x and y are one obstacle",
            MEMBER(cluster_gap_m)),
      field("min_lines", Kind::whole, 1, 256, "least lines of an obstacle", MEMBER(min_lines)),
      field("noise", Kind::whole, 0, 255,
            "grey levels of difference and gradient that the sensor owes; 255: no test of body and foot",
            MEMBER(noise)),
      field("still_px", Kind::real, 0, 100, "what a foot may seem to have moved", MEMBER(still_px)),
      field("still_rows", Kind::real, 0, 100, "as much more as an obstacle moves so many rows above its foot",
            MEMBER(still_rows)),
      field("reference_every", Kind::whole, 0, 100000,
            "frames of baseline; 0: until the parallax below is reached", MEMBER(reference.every)),
      field("reference_parallax_px", Kind::real, 0, 1000, "parallax that ends the hold of a reference",
            MEMBER(reference.parallax_px)),
      field("reference_distance_m", Kind::real, 0.1, 1000, "distance of the point whose parallax counts",
            MEMBER(reference.distance_m)),
      field("reference_height_m", Kind::real, 0, 10, "height of that point", MEMBER(reference.height_m)),
  };
  return all;
}

#undef MEMBER

[[noreturn]] void refuse(const fs::path& file, const std::string& fault) {
  throw Error(fmt::format("{}: {}; docs/command.md lists every key.", file.string(), fault));
}

const Field& field_named(const std::string& key, const fs::path& file) {
  for (const Field& candidate : fields()) {
    if (key == candidate.key) return candidate;
  }
  refuse(file, fmt::format("'{}' is no setting", key));
}

/// The value as a number; throws YAML::Exception when it is of another kind.
double number(const Field& field, const YAML::Node& value) {
  switch (field.kind) {
    case Field::Kind::flag:
      return value.as<bool>();
    case Field::Kind::whole:
      return value.as<int>();
    case Field::Kind::real:
      return value.as<double>();
    case Field::Kind::rule:
      break;
  }
  const auto name = value.as<std::string>();
  if (name != "run" && name != "paper") throw YAML::Exception(value.Mark(), "rule");
  return name == "run" ? static_cast<double>(golden::Rule::run) : static_cast<double>(golden::Rule::paper);
}

std::string text(const Field& field, double value) {
  if (field.kind == Field::Kind::flag) return value != 0 ? "true" : "false";
  if (field.kind == Field::Kind::rule)
    return value == static_cast<double>(golden::Rule::run) ? "run" : "paper";
  return report::format_value(value);
}

YAML::Node parse(const fs::path& file) {
  try {
    const YAML::Node root = YAML::Load(read_text(file));
    if (root.IsMap() || root.IsNull()) return root;
  } catch (const YAML::Exception&) {
  }
  refuse(file, "is no YAML mapping of settings");
}

}  // namespace

void read_settings(const fs::path& file, Settings& settings) {
  for (const auto& entry : parse(file)) {
    if (!entry.first.IsScalar()) refuse(file, "a key is no word");
    const Field& field = field_named(entry.first.Scalar(), file);
    try {
      const double value = number(field, entry.second);
      if (!(value >= field.low && value <= field.high))
        refuse(file, fmt::format("'{}' must lie between {} and {}", field.key, field.low, field.high));
      field.set(settings, value);
    } catch (const YAML::Exception&) {
      refuse(file, fmt::format("'{}' has a value of the wrong kind", field.key));
    }
  }
}

std::vector<report::Parameter> describe(const Settings& settings) {
  std::vector<report::Parameter> parameters;
  for (const Field& field : fields())
    parameters.push_back({field.key, text(field, field.get(settings)), field.meaning});
  return parameters;
}

}  // namespace floorline::app
