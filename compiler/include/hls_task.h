/// hls::task as the compiler sees it: the call of a function in a DATAFLOW function, marked by the compiler
/// (middle/tasks.h). (C simulation uses the project's or the vendor's own hls_task.h.)
#ifndef HLSC_INCLUDE_HLS_TASK_H
#define HLSC_INCLUDE_HLS_TASK_H

#include "hls_stream.h"

/// Streams and tasks live as long as the hardware does.
#define hls_thread_local

namespace hls {

/// A process that starts again whenever it has ended, for itself.
class task {
 public:
  task() {}
  template <class Body, class... Streams>
  task(Body&& body, Streams&&... streams) {
    (*this)(body, streams...);
  }
  template <class Body, class... Streams>
  void operator()(Body&& body, Streams&&... streams) {
    __hls_pragma("DATAFLOW", "", 0);
    body(streams...);
  }

 private:
  task(const task&);
  task& operator=(const task&);

  char handle_;  ///< Keeps it a type of its own where it is a member.
};

}  // namespace hls

#endif
