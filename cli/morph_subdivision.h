#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/body_inputs.h"
#include "cli/input_options.h"
#include "cli/session.h"
#include "recon/morphing/subdivision_morph.h"

namespace isostack::cli {

/// The options of --method subdivision as they are written. Empty or 0: not given.
struct SubdivisionMorphChoice {
  std::filesystem::path features;
  std::vector<std::filesystem::path> key_shapes;
  std::vector<double> key_shape_times;
  double sharp_angle_degrees = 0;
  int levels = 4;
  double gamma = 4;
  int smoothing_passes = 16;
  std::string details = "fade";
  std::vector<double> sweep;
  double sweep_lag = 0.8;

  bool is_default() const;
};

void add_subdivision_options(CLI::App& command, SubdivisionMorphChoice& choice);

/// Reads features and topological key shapes, these as the shapes themselves are read. Throws InputError naming the
/// file or option that is wrong.
SubdivisionMorphOptions subdivision_options(const SubdivisionMorphChoice& choice, const std::vector<KeyShape>& shapes,
                                            const InputOptions& input, const BodyOptions& bodies, Session& session);

/// The result gets "levels": vertices, energy, residual and iterations of each.
void report_levels(const MorphReport& report, Session& session);

}  // namespace isostack::cli
