/// Ctrl-C and SIGTERM: asked for between frames, so that destructors remove what is half-written.
#ifndef FLOORLINE_APPS_INTERRUPT_H
#define FLOORLINE_APPS_INTERRUPT_H

#include <exception>

namespace floorline::app {

/// Unwinds to main(), which ends with ExitCode::interrupted.
class Interrupted : public std::exception {};

/// From now on SIGINT and SIGTERM set a flag instead of ending the process; a second one ends it.
void catch_interrupts();

bool interrupted();

/// Throws Interrupted once the flag is set.
void throw_if_interrupted();

}  // namespace floorline::app

#endif
