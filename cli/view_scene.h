#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/input_options.h"
#include "cli/session.h"
#include "viewers/scene.h"

namespace isostack::cli {

/// IN... of `view`, and how it is shown.
struct ViewInput {
  InputOptions input;
  std::string input_axes = "lps";
  std::string title;
  bool has_title = false;  ///< else the files' names and key numbers
  std::string slices;  ///< all, none, middle, or numbers from 0; empty: all where there is nothing else, else middle
  double opacity = 1, slice_opacity = 1;
  std::string style = "shaded", colour = "label";
  std::filesystem::path against;
  std::vector<double> colour_range;  ///< two numbers, or empty: automatic
};

void add_view_input(CLI::App& command, ViewInput& options);

/// Everything IN... holds as one scene. Notes the readers' warnings, and what makes surfaces look wrong.
Scene read_view_scene(const ViewInput& options, Session& session);

}  // namespace isostack::cli
