#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "cli/morph_frames.h"
#include "recon/morphing/key_places.h"

namespace isostack::cli {

/// Where the key shapes lie and where frames are taken. The path is parsed when the command runs.
struct PlaceOptions {
  int frames = 16;
  std::vector<double> at;         ///< times of the frames; empty: `frames` of them, evenly from 0 to 1
  std::vector<double> key_times;  ///< of the key shapes; empty: evenly
  std::string path;               ///< "1,0,0;0,0,1;0,1,0": weights of its corners; empty: along the line

  KeyLayout layout() const { return path.empty() ? KeyLayout::line : KeyLayout::simplex; }
};

void add_place_options(CLI::App& command, PlaceOptions& options);

/// Gives the key shapes their times, if there are any. Throws InputError when there is not one for each.
void place_key_shapes(const PlaceOptions& options, std::vector<KeyShape>& shapes);

/// The frames asked for, without their shapes. Throws InputError naming the option.
std::vector<MorphFrame> places_of_frames(const KeyPlaces& places, const PlaceOptions& options);

}  // namespace isostack::cli
