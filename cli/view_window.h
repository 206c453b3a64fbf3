#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <vector>

#include "cli/session.h"
#include "cli/view_scene.h"
#include "recon/reconstruct.h"

namespace isostack::cli {

/// What `view` needs for a window beyond what it shows.
struct ViewWindow {
  bool are_frames = false;                    ///< the surfaces among IN are frames of a morph
  std::vector<std::filesystem::path> beside;  ///< a second result
  std::filesystem::path session;              ///< where it is saved; empty: the one that was opened, or a new one
  /// The fast solver stops within a moment when the window is closed; the dense one does not.
  ReconstructOptions reconstruct = {.solver = SolverChoice::fast};
};

void add_view_window(CLI::App& command, ViewWindow& options);

/// True when IN is a session that was saved.
bool is_session(const ViewInput& input);

struct WindowLook {
  int width_pixels = 1400, height_pixels = 900;
  bool dark = false;
};

/// Opens the window and returns when it is closed. Throws InputError, and Cancelled on Ctrl-C.
void open_view_window(ViewInput input, const ViewWindow& options, const WindowLook& look, Session& session);

}  // namespace isostack::cli
