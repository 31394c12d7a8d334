/// Runs the processes of DATAFLOW functions side by side in C simulation. One is at work at a time, on a
/// stack of its own, until it waits for a stream: a run is the same every time.
#ifndef HLSC_FINITE_PROCESSES_H
#define HLSC_FINITE_PROCESSES_H

#include <cstddef>
#include <string>
#include <vector>

namespace hlsc_finite {

/// What a stream is apart from its elements. The compiler's code passes its address: it stands first in the
/// stream.
struct Fifo {
  std::size_t held = 0;
  std::size_t declared = 0;  ///< Depth; 0: of the test bench, takes any number of elements.
  std::size_t added = 0;     ///< Places beyond it that were needed to go on.
  std::string name = "unnamed";
  std::vector<std::string> ends;  ///< The processes that take it.

  std::size_t places() const { return declared ? declared + added : static_cast<std::size_t>(-1); }
  bool is_ready(bool writes) const { return writes ? held < places() : held > 0; }
  /// Lets the others work until an element (to write: a place) is there. With `asks` not for ever: false when
  /// there is none and no other process can go on.
  bool wait(bool writes, bool asks);
  /// An element has gone in or out.
  void moved();
};

}  // namespace hlsc_finite

// Called by the code that the compiler makes of DATAFLOW functions (cosim/finite_fifos.h).
extern "C" {
/// `file:line:column` of the stream access that comes next.
extern const char* hlsc_place;

/// An object that a process takes by its address.
struct hlsc_object {
  const void* address;
  bool is_written;
};

/// Starts the process `body` with a copy of its arguments, when earlier processes that use the same objects,
/// and an earlier run of the same call, have ended. Returns when it has ended or waits.
void hlsc_process(void (*body)(void*), const void* arguments, std::size_t bytes, const char* name,
                  const hlsc_object* objects, std::size_t object_count);
/// Declares a stream that `process` takes from the DATAFLOW function; `depth` 0: not said, 2 unless its type
/// does.
void hlsc_declare(hlsc_finite::Fifo* fifo, std::size_t depth, const char* name, const char* process);
/// Waits for the processes that the caller has started and that write to the object.
void hlsc_await(const void* object);
/// Waits for all processes that the caller has started.
void hlsc_join();
}

#endif
