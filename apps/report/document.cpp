#include "document.h"

#include <fmt/format.h>

#include <algorithm>

namespace floorline::report {

Histogram make_histogram(const std::string& title, const std::string& unit, const std::vector<double>& values,
                         double low, double high, int bins) {
  Histogram histogram{title, unit, low, high, std::vector<int>(bins), "no values"};
  if (values.empty()) return histogram;
  for (const double value : values) {
    const int bin = static_cast<int>((value - low) / (high - low) * bins);
    ++histogram.counts[std::clamp(bin, 0, bins - 1)];
  }
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  histogram.note =
      fmt::format("{} values, median {} {}, greatest {} {}", sorted.size(),
                  format_value(sorted[sorted.size() / 2], 3), unit, format_value(sorted.back(), 3), unit);
  return histogram;
}

}  // namespace floorline::report
