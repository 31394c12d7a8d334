#include "agreement.h"

#include <algorithm>
#include <cstdlib>

namespace floorline::app {
namespace {

int distance(const golden::Contact& a, const golden::Contact& b) {
  return std::max(std::abs(a.u - b.u), std::abs(a.v - b.v));
}

}  // namespace

void Agreement::add(const std::vector<golden::Contact>& golden, const std::vector<golden::Contact>& kernel) {
  contacts_ += static_cast<long>(golden.size() + kernel.size());
  std::vector<golden::Contact> free = kernel;
  for (const golden::Contact& contact : golden) {
    auto nearest = free.end();
    for (auto candidate = free.begin(); candidate != free.end(); ++candidate) {
      if (candidate->line != contact.line) continue;
      if (nearest == free.end() || distance(*candidate, contact) < distance(*nearest, contact))
        nearest = candidate;
    }
    if (nearest == free.end()) continue;
    distances_.push_back(distance(*nearest, contact));
    free.erase(nearest);
  }
}

double Agreement::share_within_1px() const {
  if (contacts_ == 0) return 1;
  const auto close =
      std::count_if(distances_.begin(), distances_.end(), [](double distance) { return distance <= 1; });
  return 2.0 * static_cast<double>(close) / static_cast<double>(contacts_);
}

}  // namespace floorline::app
