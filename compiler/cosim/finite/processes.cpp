#include "processes.h"

#include <sys/mman.h>
#include <ucontext.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <vector>

const char* hlsc_place = "";

namespace hlsc_finite {
namespace {

constexpr std::size_t kStackBytes = std::size_t{256} << 20;  ///< Address space; memory only where it is used.
constexpr unsigned long kMostPolls = 1000000;                ///< In a row, while nothing moves.

struct Process {
  std::string name;
  Process* parent = nullptr;
  void (*body)(void*) = nullptr;
  std::vector<unsigned char> arguments;
  std::vector<hlsc_object> objects;
  ucontext_t context;
  void* stack = nullptr;
  bool has_ended = false;
  // What it waits for; no FIFO: the end of other processes.
  Fifo* fifo = nullptr;
  bool writes = false;
  const char* place = "";
};

class Scheduler {
 public:
  Scheduler() {
    processes_.push_back(std::make_unique<Process>());
    current_ = processes_[0].get();
    current_->name = "the test bench";
  }

  Process& current() { return *current_; }
  void moved() { idle_ = polls_ = 0; }

  void start(std::unique_ptr<Process> process) {
    process->parent = current_;
    wait_until([&] { return can_start(*process); });
    process->stack = stack();
    getcontext(&process->context);
    process->context.uc_stack.ss_sp = process->stack;
    process->context.uc_stack.ss_size = kStackBytes;
    process->context.uc_link = nullptr;
    makecontext(&process->context, &Scheduler::enter, 0);
    processes_.push_back(std::move(process));
    moved();
    switch_to(*processes_.back());
  }

  void await(const void* object) {
    wait_until([&] {
      for (const auto& process : processes_)
        for (const hlsc_object& taken : process->objects)
          if (process->parent == current_ && taken.address == object && taken.is_written) return false;
      return true;
    });
  }

  void join() {
    wait_until([&] {
      for (const auto& process : processes_)
        if (process->parent == current_) return false;
      return true;
    });
  }

  bool wait(Fifo& fifo, bool writes, bool asks) {
    Process& self = *current_;
    self.place = hlsc_place;
    if (asks) {
      for (std::size_t round = 0; !fifo.is_ready(writes); ++round) {
        if (idle_ >= processes_.size()) {
          if (++polls_ > kMostPolls) stand_still();
          return false;
        }
        ++idle_;
        go_on();
      }
      return true;
    }
    self.fifo = &fifo;
    self.writes = writes;
    wait_until([&] { return fifo.is_ready(writes); });
    self.fifo = nullptr;
    return true;
  }

  /// The run ends; false when FIFOs had to grow.
  bool tell_depths() {
    for (const auto& [fifo, depths] : grown_)
      std::fprintf(stderr, "  stream '%s': depth %zu would do, it is %zu\n", depths.name.c_str(),
                   depths.declared + depths.added, depths.declared);
    return grown_.empty();
  }

 private:
  struct Depths {
    std::string name;
    std::size_t declared, added;
  };

  static void enter();

  template <class Condition>
  void wait_until(Condition condition) {
    while (!condition()) {
      // All have been asked since something moved, and those that poll get their turns, too.
      if (++idle_ > 2 * processes_.size()) stand_still();
      go_on();
    }
  }

  /// Gives the next process its turn.
  void go_on() {
    std::size_t at = 0;
    while (processes_[at].get() != current_) ++at;
    switch_to(*processes_[(at + 1) % processes_.size()]);
  }

  void switch_to(Process& next) {
    Process& before = *current_;
    if (&next == &before) return;
    current_ = &next;
    swapcontext(&before.context, &next.context);
    remove_ended();
  }

  void remove_ended() {
    for (std::size_t i = 0; i < processes_.size(); ++i)
      if (processes_[i]->has_ended && processes_[i].get() != current_) {
        stacks_.push_back(processes_[i]->stack);
        processes_.erase(processes_.begin() + i--);
      }
  }

  void* stack() {
    if (!stacks_.empty()) {
      void* kept = stacks_.back();
      stacks_.pop_back();
      return kept;
    }
    void* made = mmap(nullptr, kStackBytes, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0);
    if (made != MAP_FAILED) return made;
    std::fprintf(stderr, "error: no memory for the stack of a process\n");
    std::exit(3);
  }

  bool can_start(const Process& process) const {
    for (const auto& other : processes_) {
      if (other->parent != process.parent || other->has_ended) continue;
      if (other->body == process.body) return false;
      for (const hlsc_object& mine : process.objects)
        for (const hlsc_object& theirs : other->objects)
          if (mine.address == theirs.address && (mine.is_written || theirs.is_written)) return false;
    }
    return true;
  }

  /// Nothing moves: tells it once, makes the FIFOs that are full larger by a place, or ends the run.
  void stand_still() {
    if (!is_told_) tell_waits();
    is_told_ = true;
    bool grows = false;
    for (const auto& process : processes_) {
      Fifo* fifo = process->fifo;
      if (!fifo || !process->writes || fifo->is_ready(true)) continue;
      ++fifo->added;
      grown_[fifo->name] = {fifo->name, fifo->declared, fifo->added};
      grows = true;
    }
    moved();
    if (grows) return;
    if (grown_.empty()) std::fprintf(stderr, "  deeper FIFOs do not help: elements are missing\n");
    std::fflush(stdout);
    std::_Exit(3);
  }

  void tell_waits() const {
    std::fprintf(stderr, "error: C simulation with finite FIFOs stands still:\n");
    for (const auto& process : processes_) {
      if (!process->fifo) continue;
      const Fifo& fifo = *process->fifo;
      std::string state = process->writes ? "full, depth " + std::to_string(fifo.places()) : "empty";
      std::string other;
      for (const std::string& end : fifo.ends)
        if (end != process->name)
          other = std::string("; ") + (process->writes ? "read" : "written") + " by '" + end + "'";
      std::fprintf(stderr, "  '%s' waits at %s to %s '%s', which is %s%s\n", process->name.c_str(),
                   process->place, process->writes ? "write" : "read", fifo.name.c_str(), state.c_str(),
                   other.c_str());
    }
  }

  std::vector<std::unique_ptr<Process>> processes_;  ///< The first is the test bench.
  Process* current_ = nullptr;
  std::vector<void*> stacks_;
  std::size_t idle_ = 0;     ///< Turns since something moved.
  unsigned long polls_ = 0;  ///< Answers `none there` since something moved.
  bool is_told_ = false;
  std::map<std::string, Depths> grown_;
};

Scheduler& scheduler() {
  static Scheduler* one = new Scheduler;  // Streams may be used while the program ends.
  return *one;
}

void Scheduler::enter() {
  Process& self = scheduler().current();
  scheduler().remove_ended();
  self.body(self.arguments.data());
  scheduler().join();
  self.has_ended = true;
  scheduler().moved();
  scheduler().go_on();
}

/// At the end of the program: a run in which FIFOs had to grow has failed.
struct LastWord {
  LastWord() { scheduler(); }
  ~LastWord() {
    std::fflush(stdout);
    if (!scheduler().tell_depths()) std::_Exit(3);
  }
} last_word;

}  // namespace

bool Fifo::wait(bool writes, bool asks) { return scheduler().wait(*this, writes, asks); }

void Fifo::moved() { scheduler().moved(); }

}  // namespace hlsc_finite

void hlsc_process(void (*body)(void*), const void* arguments, std::size_t bytes, const char* name,
                  const hlsc_object* objects, std::size_t object_count) {
  auto process = std::make_unique<hlsc_finite::Process>();
  process->name = name;
  process->body = body;
  process->arguments.assign(static_cast<const unsigned char*>(arguments),
                            static_cast<const unsigned char*>(arguments) + bytes);
  process->objects.assign(objects, objects + object_count);
  hlsc_finite::scheduler().start(std::move(process));
}

void hlsc_declare(hlsc_finite::Fifo* fifo, std::size_t depth, const char* name, const char* process) {
  std::vector<std::string>& ends = fifo->ends;
  if (std::find(ends.begin(), ends.end(), process) == ends.end()) ends.push_back(process);
  if (depth)
    fifo->declared = depth;
  else if (!fifo->declared)
    fifo->declared = 2;
  if (fifo->name == "unnamed") fifo->name = name;
}

void hlsc_await(const void* object) { hlsc_finite::scheduler().await(object); }

void hlsc_join() { hlsc_finite::scheduler().join(); }
