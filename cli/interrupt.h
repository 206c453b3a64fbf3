#pragma once

namespace isostack::cli {

/// From now on Ctrl-C (SIGINT) and SIGTERM ask to stop instead of killing the program; a later
/// second one kills it; two within half a second count as one.
void watch_for_interrupts();

/// Whether one came.
bool interrupted();

}  // namespace isostack::cli
