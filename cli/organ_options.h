#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "segmentation/organs.h"

namespace isostack::cli {

/// What beyond --level says where organs are in grey images: seeds, rules, the steps of the start, the evolution's
/// terms. The texts are parsed when the command runs.
struct OrganInput {
  std::vector<double> range;  ///< low, high; empty: not given
  bool otsu = false, otsu_darker = false;
  std::vector<std::string> seeds;  ///< "X,Y,Z[,name]"
  double spread = 0;               ///< 0: not given
  std::vector<double> diffusion;   ///< contrast, steps
  std::vector<std::string> start;  ///< texts of steps; "labels:FILE[,N]" besides those of parse_start_step
  double open_mm = 0, close_mm = 0;
  bool hull = false;
  double propagate_mm = 0;
  bool in_volume = false;
  EvolutionOptions evolution;
  std::filesystem::path distance_file;  ///< of signed distances; only `segment` asks for it

  bool has_rule() const { return !range.empty() || otsu || otsu_darker || !seeds.empty() || !start.empty(); }
};

void add_organ_options(CLI::App& command, OrganInput& options);

struct InputOptions;

/// The start and evolution that the options of a command line describe, shorthands in their fixed order:
/// filters, rule, --start, --open, connected, --close, --hull, --fill-holes, --largest.
/// Throws InputError naming the option.
OrganOptions organ_options(const InputOptions& options);

}  // namespace isostack::cli
