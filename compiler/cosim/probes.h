/// What the modules' probes (verilog/emit_probes.h) tell a co-simulation, and how it is told to the user: who
/// waits for whom when nothing moves, the intervals of loops, and how far FIFOs filled. Included by the
/// adapter only.
#ifndef HLSC_COSIM_PROBES_H
#define HLSC_COSIM_PROBES_H

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace hlsc_cosim {

class Probes {
 public:
  enum WaitKind { kWrite = 0, kRead = 1, kFill = 2, kTake = 3 };
  struct Wait {
    std::string who, what, place;
    int kind;
  };
  struct Fifo {
    int depth = 0, held = 0, most = 0;
  };
  struct Loop {
    std::string who, name, place;
    int ii;
    uint64_t intervals, cycles;
  };

  static Probes& all() {
    static Probes probes;
    return probes;
  }

  // Called by the modules.
  void run_ends() { ++runs_; }
  bool asked() const { return asked_; }
  void wait(const Wait& wait) { waits_.push_back(wait); }
  void end(const std::string& who, const std::string& port, const std::string& stream, bool is_reader) {
    ends_[{who, port}] = stream;
    partners_[{stream, is_reader}] = who;
  }
  void fifo(const std::string& name, const Fifo& fifo) { fifos_[name] = fifo; }
  void loop(const Loop& loop) { loops_.push_back(loop); }
  /// An access of a later iteration (`distance` 0: behind it in the same) came before another to the same word.
  void dependence(const std::string& who, const std::string& array, const std::string& early,
                  const std::string& late, int distance) {
    if (!told_.insert({who, array}).second) return;
    std::string whose = distance == 0   ? "the same iteration"
                        : distance == 1 ? "1 iteration earlier"
                                        : std::to_string(distance) + " iterations earlier";
    std::fprintf(stderr,
                 "warning: DEPENDENCE false of '%s' in '%s' does not hold: %s comes before %s of %s, to the "
                 "same element\n",
                 array.c_str(), name_of(who).c_str(), early.c_str(), late.c_str(), whose.c_str());
  }
  int extra_places(const std::string& stream) const {
    auto found = extra_.find(stream);
    return found == extra_.end() ? 0 : found->second;
  }

  /// The process of a top that is one: its instance is `core`.
  void name_core(const std::string& name) { core_ = name; }

  /// Whether this run looks for depths that would do: HLSC_DEPTHS is the file to write them to.
  static const char* depths_file() { return std::getenv("HLSC_DEPTHS"); }

  /// Runs that have ended, of a top without ap_done.
  uint64_t runs() const { return runs_; }

  /// Asks all modules in the clock edge that `edge` makes.
  template <class Edge>
  void ask(Edge edge) {
    asked_ = true;
    waits_.clear();
    edge();
    asked_ = false;
  }

  /// After ask: one line for each process that waits. Leaves a note for the command that started the run
  /// whether deeper FIFOs may help.
  void tell_waits() const {
    for (const Wait& wait : waits_) std::fprintf(stderr, "  %s\n", sentence(wait).c_str());
    if (const char* note = std::getenv("HLSC_STANDS_STILL"))
      if (std::FILE* file = std::fopen(note, "w")) {
        std::fputs(smallest_full().empty() ? "starved\n" : "full\n", file);
        std::fclose(file);
      }
  }

  /// Gives the smallest full FIFO one more place. False when none is full, or it has grown too far.
  bool grow() {
    std::string stream = smallest_full();
    return !stream.empty() && ++extra_[stream] <= kMostExtra;
  }

  /// At the end of the run.
  void tell_run() const {
    for (const Loop& loop : loops_)
      std::fprintf(stderr, "  loop %s of '%s' (%s): II %d by schedule, %.2f measured\n", loop.name.c_str(),
                   name_of(loop.who).c_str(), loop.place.c_str(), loop.ii,
                   double(loop.cycles) / loop.intervals);
    for (const auto& [name, fifo] : fifos_)
      std::fprintf(stderr, "  stream '%s': depth %d, held %d at most%s\n", name.c_str(), fifo.depth,
                   fifo.most, fifo.most >= fifo.depth ? ": its writer may have waited" : "");
    if (const char* note = depths_file())
      if (std::FILE* file = std::fopen(note, "w")) {
        for (const auto& [stream, extra] : extra_)
          std::fprintf(file, "%s %d %d\n", stream.c_str(), fifos_.at(stream).depth,
                       fifos_.at(stream).depth + extra);
        std::fclose(file);
      }
  }

 private:
  static constexpr int kMostExtra = 4096;

  /// The stream behind a process' port.
  std::string stream_of(const Wait& wait) const {
    auto found = ends_.find({wait.who, wait.what});
    return found == ends_.end() ? wait.what : found->second;
  }

  const std::string& name_of(const std::string& who) const { return who == "core" ? core_ : who; }

  std::string sentence(const Wait& wait) const {
    std::string stream = stream_of(wait), place = wait.place.empty() ? "" : " at " + wait.place;
    if (wait.kind == kFill || wait.kind == kTake)
      return "'" + name_of(wait.who) + "' waits to start until a bank of array '" + wait.what + "' is " +
             (wait.kind == kFill ? "free" : "filled");
    auto fifo = fifos_.find(stream);
    bool is_read = wait.kind == kRead;
    std::string state = is_read                ? "empty"
                        : fifo == fifos_.end() ? "not taken by the test bench"
                                               : "full, depth " + std::to_string(fifo->second.depth);
    auto partner = partners_.find({stream, !is_read});
    std::string by = partner == partners_.end()
                         ? (is_read ? "; the test bench gives no more" : "")
                         : (is_read ? "; written by '" : "; read by '") + partner->second + "'";
    return "'" + name_of(wait.who) + "' waits" + place + " to " + (is_read ? "read" : "write") + " '" +
           stream + "', which is " + state + by;
  }

  /// Of the FIFOs that a process waits to write; empty when there is none.
  std::string smallest_full() const {
    std::string smallest;
    int least = 0;
    for (const Wait& wait : waits_) {
      std::string stream = stream_of(wait);
      auto fifo = fifos_.find(stream);
      if (wait.kind != kWrite || fifo == fifos_.end()) continue;
      int places = fifo->second.depth + extra_places(stream);
      if (smallest.empty() || places < least) {
        smallest = stream;
        least = places;
      }
    }
    return smallest;
  }

  uint64_t runs_ = 0;
  bool asked_ = false;
  std::string core_;
  std::vector<Wait> waits_;
  std::map<std::pair<std::string, std::string>, std::string> ends_;  ///< Process and port -> stream.
  std::map<std::pair<std::string, bool>, std::string>
      partners_;  ///< Stream and whether its reader -> process.
  std::map<std::string, Fifo> fifos_;
  std::vector<Loop> loops_;
  std::set<std::pair<std::string, std::string>> told_;  ///< Processes and arrays out of order.
  std::map<std::string, int> extra_;                    ///< Places that streams have been given.
};

/// The last name of a path of instances: top.inst -> inst.
inline std::string last_name(const std::string& path) { return path.substr(path.find_last_of('.') + 1); }

}  // namespace hlsc_cosim

extern "C" {
int hlsc_asked() { return hlsc_cosim::Probes::all().asked(); }
void hlsc_run_ends() { hlsc_cosim::Probes::all().run_ends(); }
void hlsc_waits(const char* who, const char* what, const char* place, int kind) {
  hlsc_cosim::Probes::all().wait({hlsc_cosim::last_name(who), what, place, kind});
}
void hlsc_end(const char* who, const char* port, const char* stream, int is_reader) {
  hlsc_cosim::Probes::all().end(who, port, stream, is_reader);
}
void hlsc_fifo(const char* name, int depth, int held, int most) {
  hlsc_cosim::Probes::all().fifo(name, {depth, held, most});
}
void hlsc_loop(const char* who, const char* name, const char* place, int ii, long long intervals,
               long long cycles) {
  hlsc_cosim::Probes::all().loop(
      {hlsc_cosim::last_name(who), name, place, ii, uint64_t(intervals), uint64_t(cycles)});
}
void hlsc_dependence(const char* who, const char* name, const char* early, const char* late, int distance) {
  hlsc_cosim::Probes::all().dependence(hlsc_cosim::last_name(who), name, early, late, distance);
}
int hlsc_extra_places(const char* who) {
  std::string name = hlsc_cosim::last_name(who);  // Of the FIFO: STREAM_fifo.
  return hlsc_cosim::Probes::all().extra_places(name.substr(0, name.rfind("_fifo")));
}
}

#endif
