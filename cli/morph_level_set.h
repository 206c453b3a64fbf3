#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "cli/session.h"
#include "recon/morphing/level_set_morph.h"

namespace isostack::cli {

/// The options of --method level-set as they are written.
struct LevelSetMorphChoice {
  std::string approach = "identity", pace = "volume", transform = "none", missing_parts = "leave";
  double width_pixels = 4, stop_rms_pixels = 0.1;

  bool is_default() const;
};

void add_level_set_options(CLI::App& command, LevelSetMorphChoice& choice);

/// `base` gives what is no choice: landmarks (a warp through them unless another transform was chosen), resolution and
/// memory. Before it runs, a note for each part that stays missing or is seeded. The result gets "unshared_parts"
/// and, under "courses", how each evolution went.
Morph morph_by_level_sets(const std::vector<KeyShape>& shapes, const LevelSetMorphChoice& choice,
                          LevelSetMorphOptions base, Session& session);

}  // namespace isostack::cli
