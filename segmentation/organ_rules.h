#pragma once

#include <optional>
#include <vector>

#include "segmentation/diffusion.h"
#include "segmentation/evolve_region.h"
#include "segmentation/organs.h"
#include "segmentation/seeds.h"
#include "segmentation/start_steps.h"
#include "segmentation/threshold.h"

namespace isostack {

/// Where organs are in grey images, said the short way: at most one rule of grey values (level, range, Otsu or spread),
/// filters before it, clean-up after it. The command line and the Python module have these as options.
struct OrganRules {
  std::optional<double> level = {};     ///< at least this bright
  bool darker = false;                  ///< than the level, at most this bright
  std::optional<GreyRange> range = {};  ///< grey values between these
  bool otsu = false;                    ///< brighter than Otsu's level
  bool otsu_darker = false;             ///< darker than it
  std::vector<Seed> seeds = {};         ///< points of the organs: one organ per name
  /// Of seeds without another rule: grey values within this many standard deviations of theirs. Unset: 2.5.
  std::optional<double> spread = {};
  double gaussian_sigma_pixels = 0;                ///< low-pass filter; 0: none
  std::optional<DiffusionOptions> diffusion = {};  ///< edge-keeping filter
  std::vector<StartStep> start = {};               ///< further steps, after the rule, in this order
  double open_mm = 0;                              ///< parts what hangs together by less than twice this; 0: none
  double close_mm = 0;                             ///< fills gaps narrower than twice this; 0: none
  bool hull = false;                               ///< every part becomes its convex hull, slice by slice
  bool fill_holes = false;                         ///< per slice: background enclosed by the organ becomes organ
  bool largest = false;                            ///< the largest connected part only
  double propagate_mm = 0;                         ///< as OrganOptions have it
  bool in_volume = false;                          ///< as OrganOptions have it
  EvolutionOptions evolution = {};                 ///< as OrganOptions have it
};

/// The same step by step: filters, rule, `start`, opening, what is connected to the seeds, closing, hull, holes,
/// largest part. Throws InputError when there are several rules, or a range that is none.
OrganOptions organ_options(const OrganRules& rules);

}  // namespace isostack
