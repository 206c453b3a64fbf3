#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "cli/morph_frames.h"
#include "cli/session.h"
#include "recon/morphing/blend_morph.h"

namespace isostack::cli {

/// The options of --method blend as they are written. Empty lists: not given.
struct BlendMorphChoice {
  std::string ends = "smoothed";
  std::vector<double> slab, gap;              ///< from, to: in shares of the way between two shapes
  std::vector<double> blend, smoothing;       ///< a0, a1, a2, a3
  std::vector<double> pulled, pulled_during;  ///< a point and where it goes; from, to
  double pull_radius_mm = 0, length_mm = 0;   ///< 0: not given

  bool is_default() const;
};

void add_blend_options(CLI::App& command, BlendMorphChoice& choice);

BlendMorphOptions blend_options(const BlendMorphChoice& choice, double resolution_mm);

/// A note when frames have more pieces than any of the shapes. The result gets "most_given_components" and
/// "stray_frames".
void report_stray(const std::vector<MorphFrame>& frames, const std::vector<KeyShape>& shapes, Session& session);

}  // namespace isostack::cli
