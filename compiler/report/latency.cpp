#include "report/latency.h"

#include <algorithm>

namespace hlsc {
namespace {

/// For choosing the longer of two ways: an unknown number of iterations counts as many.
constexpr uint64_t kUnknownTerm = 1000000;

uint64_t weight(const Latency& latency) {
  return latency.is_endless ? UINT64_MAX : latency.cycles + kUnknownTerm * latency.terms.size();
}

Latency sum(Latency a, const Latency& b) {
  a.cycles += b.cycles;
  a.terms.insert(a.terms.end(), b.terms.begin(), b.terms.end());
  a.is_bound |= b.is_bound;
  a.is_endless |= b.is_endless;
  return a;
}

Latency times(const std::string& count, const Latency& body) {
  Latency out;
  out.is_bound = body.is_bound;
  out.is_endless = body.is_endless;
  bool is_plain = body.terms.empty();
  out.terms = {count + " * " + (is_plain ? std::to_string(body.cycles) : "(" + body.text() + ")")};
  return out;
}

Latency times(uint64_t count, const Latency& body) {
  if (!body.terms.empty()) return times(std::to_string(count), body);
  Latency out = body;
  out.cycles *= count;
  return out;
}

}  // namespace

std::string Latency::text() const {
  if (is_endless) return "endless";
  std::string out;
  for (const std::string& term : terms) out += (out.empty() ? "" : " + ") + term;
  if (cycles || out.empty()) out += (out.empty() ? "" : " + ") + std::to_string(cycles);
  return out;
}

LatencyModel::LatencyModel(const Process& process, const ProcessSchedule& schedule)
    : process_(process), schedule_(schedule) {}

Latency LatencyModel::process() {
  Latency way = longest(0, -1);
  if (process_.call_loop() < 0) way.cycles += 1;  // The state in which it waits for its start.
  return way;
}

Latency LatencyModel::loop(int index) {
  const SourceLoop& loop = process_.loops[index];
  const BlockSchedule& timing = schedule_.blocks[loop.header];
  const Block& header = process_.blocks[loop.header];
  bool is_exact = loop.most_trips && loop.least_trips == loop.most_trips;
  Latency total;
  if (header.takes_calls) {
    total.cycles = timing.length;
  } else if (header.is_loop) {
    if (header.terminator.kind == Terminator::kJump) {
      total.is_endless = true;
      return total;
    }
    uint64_t fill = timing.length - timing.ii;
    total.cycles = loop.most_trips * timing.ii + fill;
    if (!loop.most_trips)
      total.terms = {"N(" + loop.name + ")" + (timing.ii == 1 ? "" : " * " + std::to_string(timing.ii))};
  } else {
    Latency body = longest(loop.header, index);
    total = loop.most_trips ? times(loop.most_trips, body) : times("N(" + loop.name + ")", body);
  }
  total.is_bound |= loop.most_trips && !is_exact;
  return total;
}

Latency LatencyModel::longest(int from, int loop) {
  auto known = longest_.find({from, loop});
  if (known != longest_.end()) return known->second;
  int inner = loop_entered(from, loop);
  Latency way = inner < 0 ? block(from) : this->loop(inner);
  std::vector<int> targets;
  if (inner < 0)
    targets = process_.blocks[from].terminator.targets;
  else
    for (int member : process_.loops[inner].blocks)
      for (int target : process_.blocks[member].terminator.targets)
        if (!contains(inner, target)) targets.push_back(target);
  return longest_[{from, loop}] = sum(way, rest(targets, loop));
}

Latency LatencyModel::rest(const std::vector<int>& targets, int loop) {
  Latency longest_way;
  uint64_t least = UINT64_MAX;
  for (int target : targets) {
    bool leaves = loop >= 0 && (!contains(loop, target) || target == process_.loops[loop].header);
    Latency way = leaves ? Latency() : longest(target, loop);
    least = std::min(least, weight(way));
    if (weight(way) >= weight(longest_way)) longest_way = way;
  }
  longest_way.is_bound |= !targets.empty() && least != weight(longest_way);
  return longest_way;
}

Latency LatencyModel::block(int index) const {
  const Block& b = process_.blocks[index];
  Latency out;
  bool is_passed_over = b.operations.empty() && !b.is_loop &&
                        (b.terminator.kind == Terminator::kJump || b.terminator.kind == Terminator::kReturn);
  out.cycles = is_passed_over ? 0 : schedule_.blocks[index].length;
  return out;
}

int LatencyModel::loop_entered(int block, int loop) const {
  for (size_t i = 0; i < process_.loops.size(); ++i)
    if (process_.loops[i].header == block && process_.loops[i].parent == loop) return i;
  return -1;
}

bool LatencyModel::contains(int loop, int block) const {
  const std::vector<int>& blocks = process_.loops[loop].blocks;
  return std::find(blocks.begin(), blocks.end(), block) != blocks.end();
}

}  // namespace hlsc
