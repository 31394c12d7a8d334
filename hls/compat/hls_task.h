/// hls::task for C simulation: a function that is called for ever, on a stack of its own. The tasks work
/// while the program waits for a stream: one after the other, each until it waits itself, so that a run is
/// the same every time.
#ifndef HLS_TASK_H
#define HLS_TASK_H

#include <ucontext.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "hls_stream.h"

/// Streams and tasks of a function that is called again are the same ones.
#define hls_thread_local thread_local

namespace hls {
namespace task_detail {

class Scheduler {
 public:
  static Scheduler& all() {
    static Scheduler scheduler;
    return scheduler;
  }

  void add(std::function<void()> body) {
    stream_detail::Shared<>::others = [] { return all().others_moved(); };
    std::unique_ptr<Fiber> fiber(new Fiber);
    fiber->body = std::move(body);
    fiber->stack.reset(new char[kStackBytes]);
    getcontext(&fiber->context);
    fiber->context.uc_stack.ss_sp = fiber->stack.get();
    fiber->context.uc_stack.ss_size = kStackBytes;
    fiber->context.uc_link = nullptr;
    makecontext(&fiber->context, [] { all().run_for_ever(); }, 0);
    fibers_.push_back(std::move(fiber));
  }

 private:
  struct Fiber {
    ucontext_t context;
    std::function<void()> body;
    std::unique_ptr<char[]> stack;
  };

  /// Large enough for the local arrays of a kernel.
  static const std::size_t kStackBytes = std::size_t(1) << 20;

  void run_for_ever() {
    const std::function<void()>& body = fibers_[at_work_]->body;
    while (true) body();
  }

  /// What whoever waits calls: a task lets the others go on, the program lets all tasks work until none can.
  bool others_moved() {
    if (in_task_) {
      swapcontext(&fibers_[at_work_]->context, &program_);
      return true;
    }
    const unsigned long long before = stream_detail::Shared<>::transfers;
    unsigned long long seen;
    do {
      seen = stream_detail::Shared<>::transfers;
      for (at_work_ = 0; at_work_ < fibers_.size(); ++at_work_) {
        in_task_ = true;
        swapcontext(&program_, &fibers_[at_work_]->context);
        in_task_ = false;
      }
    } while (stream_detail::Shared<>::transfers != seen);
    return stream_detail::Shared<>::transfers != before;
  }

  std::vector<std::unique_ptr<Fiber>> fibers_;
  ucontext_t program_;
  std::size_t at_work_ = 0;
  bool in_task_ = false;
};

}  // namespace task_detail

/// Calls body(streams...) again and again, from its construction or its first call on to the program's end.
class task {
 public:
  task() {}
  template <class Body, class... Streams>
  task(Body&& body, Streams&&... streams) {
    (*this)(body, streams...);
  }
  task(const task&) = delete;
  task& operator=(const task&) = delete;

  template <class Body, class... Streams>
  void operator()(Body&& body, Streams&&... streams) {
    if (is_started_) return;
    is_started_ = true;
    task_detail::Scheduler::all().add([&body, &streams...] { body(streams...); });
  }

 private:
  bool is_started_ = false;
};

}  // namespace hls

#endif
