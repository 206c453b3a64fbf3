#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>

#include "cli/input_options.h"
#include "io/write_options.h"

namespace isostack::cli {

/// The images that a written DICOM object refers to, and whether it takes over who the patient is.
struct LikeOptions {
  std::filesystem::path series;  ///< empty: the input, when that is a DICOM image series
  std::string series_choice;     ///< as --series
  bool identify = false;
};

void add_like_options(CLI::App& command, LikeOptions& options);

/// For writing what came from `input`. Without --like it is the first input that is a DICOM image series, or the images
/// that a structure set was drawn on (--images); without any of these `like` stays empty.
WriteOptions write_options_for(const LikeOptions& options, const InputOptions& input);

}  // namespace isostack::cli
