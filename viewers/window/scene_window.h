#pragma once

#include <cstddef>
#include <functional>

#include "viewers/window/window_model.h"

namespace isostack {

struct SceneWindowOptions {
  int width_pixels = 1400;
  int height_pixels = 900;
  std::function<bool()> is_interrupted = {};  ///< asked many times a second; true closes the window
};

/// What happened, with times in ms. An answer is the time from an event's arrival, at the earliest it can have come, to
/// the end of the drawing that shows what it did.
struct SceneWindowReport {
  double opened_ms = 0;  ///< from the call to the first picture
  std::size_t events = 0, frames = 0;
  double slowest_frame_ms = 0;
  double slowest_answer_ms = 0;
  std::size_t events_while_busy = 0;  ///< while work ran in the background
  double slowest_answer_while_busy_ms = 0;
  double closing_ms = 0;  ///< until work that still ran had stopped
};

/// Opens a window, in which keys and pointer do what `view_keys()` says, and comes back when it is closed. To be called
/// from one thread at a time. Throws InputError when there is no display, or the content cannot be shown.
SceneWindowReport open_scene_window(WindowContent content, const SceneWindowOptions& options = {});

}  // namespace isostack
