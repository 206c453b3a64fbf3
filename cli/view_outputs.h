#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/session.h"
#include "viewers/scene.h"
#include "viewers/screenshot.h"

namespace isostack::cli {

/// What `view` writes without a window.
struct ViewOutputs {
  std::filesystem::path screenshot, html;
  int turntable = 0;  ///< pictures of one turn; 0: one picture
  bool montage = false, contradiction = false;
  double frames_per_second = 12.5;
  std::string size = "1200x900", camera;
  std::vector<double> view_from, window_level;
  bool dark = false, light = false, axes = false, no_marks = false;

  bool any() const { return !screenshot.empty() || !html.empty(); }
  ScreenshotOptions picture_options() const;
};

void add_view_outputs(CLI::App& command, ViewOutputs& options);

/// Throws InputError before anything is read when the outputs could not be written at the end.
void require_writable(const ViewOutputs& options);

void write_view_outputs(const Scene& scene, const ViewOutputs& options, Session& session);

}  // namespace isostack::cli
