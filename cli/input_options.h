#pragma once

#include <CLI/App.hpp>
#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/organ_options.h"
#include "cli/session.h"
#include "io/read_slices.h"
#include "recon/geometry/contour.h"
#include "segmentation/segment.h"

namespace isostack::cli {

/// IN..., how to read it, which slices of it to use, and how grey values or labels become contours.
struct InputOptions {
  std::vector<std::filesystem::path> paths;
  std::string series;
  int phase = 0;  ///< 0: not given
  std::vector<double> spacing_mm;
  int every = 1;
  std::vector<int> slices;
  std::vector<std::string> organs;  ///< of contour files; empty: all
  bool unite_contours = false;
  std::filesystem::path images;

  std::string level;  ///< text, so that "not given" can be told from 0
  std::string label;
  bool darker = false;
  SegmentationOptions segmentation;
  OrganInput organ;

  ReadOptions read_options() const;
};

void add_reading_options(CLI::App& command, InputOptions& options);
/// The part of it that says which of several things in an input is meant.
void add_source_options(CLI::App& command, InputOptions& options);
void add_slice_choice(CLI::App& command, InputOptions& options);
void add_segmentation_options(CLI::App& command, InputOptions& options);

/// All image inputs as one scene, before slices are chosen. Notes the readers' warnings.
SliceStack read_images(const InputOptions& options, Session& session);

/// The slices that --every and --slices keep.
SliceStack chosen_slices(const SliceStack& stack, const InputOptions& options);

/// Contours of every organ asked for: read from contour files, or traced in the images.
/// Throws InputError when neither --level nor --label says what to look for.
std::vector<ContourStack> organs_from(const InputOptions& options, Session& session);

/// As organs_from without organs that have no contours, as structure sets often hold; each is noted.
std::vector<ContourStack> drawn_organs_from(const InputOptions& options, Session& session);

/// The given --level as a number.
double level_of(const InputOptions& options);

}  // namespace isostack::cli
