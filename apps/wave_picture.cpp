#include "wave_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "svg.h"

namespace floorline::app {
namespace {

constexpr int kLeft = 150, kColumn = 38, kRow = 24, kHigh = 4, kLow = 18, kHead = 24;
constexpr const char *kMark = "#d9480f", *kShade = "#d9480f22";

using cosim::PortState;

class Drawing {
 public:
  explicit Drawing(const cosim::PortWatch& watch) : watch_(watch) {}

  std::string finish() {
    const auto& cycles = watch_.cycles();
    const int width = kLeft + kColumn * static_cast<int>(cycles.size());
    for (std::size_t port = 0; port < cosim::kPortNames.size(); ++port) {
      if (offers_something(port) || port == differing()) add_port(port);
    }
    std::string head = svg::label(kLeft - 8, 14, "end", "cycle");
    for (std::size_t i = 0; i < cycles.size(); i += 4)
      head += svg::label(x(i), 14, "start", std::to_string(cycles[i].cycle));
    if (watch_.passed()) head += svg::box(x(watch_.passed_at()), kHead, kColumn, y_ - kHead, kShade);
    return svg::picture(width, y_, head + body_);
  }

 private:
  static int x(std::size_t cycle) { return kLeft + kColumn * static_cast<int>(cycle); }
  std::size_t differing() const { return index(watch_.port()); }
  const PortState& state(std::size_t cycle, std::size_t port) const {
    return watch_.cycles()[cycle].ports[port];
  }

  bool offers_something(std::size_t port) const {
    return std::any_of(watch_.cycles().begin(), watch_.cycles().end(),
                       [&](const cosim::PortCycle& cycle) { return cycle.ports[port].valid; });
  }

  void add_port(std::size_t port) {
    add_bit(port, "tvalid", &PortState::valid);
    add_bit(port, "tready", &PortState::ready);
    name_row(port, "tdata");
    for (std::size_t i = 0; i < watch_.cycles().size(); ++i) add_data(port, i);
    y_ += kRow + kRow / 3;
  }

  void name_row(std::size_t port, const char* signal) {
    body_ +=
        svg::label(kLeft - 8, y_ + kLow - 3, "end", fmt::format("{} {}", cosim::kPortNames[port], signal));
  }

  void add_bit(std::size_t port, const char* signal, bool PortState::* bit) {
    name_row(port, signal);
    std::string points;
    for (std::size_t i = 0; i < watch_.cycles().size(); ++i) {
      const int level = y_ + (state(i, port).*bit ? kHigh : kLow);
      points += fmt::format("{},{} {},{} ", x(i), level, x(i + 1), level);
    }
    body_ += svg::line(points, port == differing() ? kMark : svg::kBlue);
    y_ += kRow;
  }

  /// Framed where it is valid, filled where it moves.
  void add_data(std::size_t port, std::size_t cycle) {
    const PortState& now = state(cycle, port);
    if (!now.valid) return;
    const int left = x(cycle) + 1, top = y_ + kHigh - 2, bottom = y_ + kLow + 2, right = x(cycle + 1) - 1;
    if (now.moves()) body_ += svg::box(left, top, right - left, bottom - top, kShade);
    body_ += svg::line(fmt::format("{0},{1} {2},{1} {2},{3} {0},{3} {0},{1}", left, top, right, bottom),
                       port == differing() ? kMark : svg::kBlue);
    body_ +=
        svg::label((left + right) / 2, y_ + kLow - 3, "middle", fmt::format("{:04x}", now.data[0] & 0xffff));
  }

  const cosim::PortWatch& watch_;
  int y_ = kHead;  ///< Of the next row.
  std::string body_;
};

}  // namespace

std::string wave_picture(const cosim::PortWatch& watch) { return Drawing(watch).finish(); }

}  // namespace floorline::app
