#pragma once

#include <optional>
#include <string>

#include "recon/geometry/progress.h"
#include "segmentation/field.h"
#include "segmentation/level_set.h"
#include "segmentation/threshold.h"

namespace isostack {

/// Weights of the terms of the evolution after the start; 0: the term is absent. Without any of curvature, region, edge
/// and balloon the start is the result. Lengths in pixels refer to the smallest spacing.
struct EvolutionOptions {
  double curvature = 0;  ///< β of CurvatureTerm, pixels
  /// Of the IsosurfaceTerm on the edge of the rule's range. Unset: 1, or 0 where region or edge take its place.
  std::optional<double> range_weight = std::nullopt;
  double region = 0;            ///< of RegionTerm
  double region_window_mm = 0;  ///< its means are local; 0: over the whole slice or volume
  double edge = 0;              ///< of EdgeTerm (ℓ = edge pixels)
  double edge_contrast = 0;     ///< grey values per mm; 0: twice the root mean square slope of the image
  double balloon = 0;           ///< > 0 grows, < 0 shrinks; stopped by edges when edge > 0
  double stay_mm = 0;           ///< > 0: the result exceeds the start by no more than this, whatever the speed says
  int max_steps = 100;          ///< at most

  bool is_active() const { return curvature > 0 || region > 0 || edge > 0 || balloon != 0; }
};

/// Evolves a region (>= 0 inside, any scale) on its grey values. Returns the signed distance in mm next to the curve
/// (narrow_band_pixels), ± the width of that band elsewhere. `where` names the slice or volume in messages. Throws
/// Cancelled when `progress` says so, InputError when a region that could hold out against the curvature vanishes, or
/// when a region of less than half the image fills nearly all of it. `observer` sees every state (level_set.h).
template <int D>
Field<D> evolve_region(Field<D> start, const Field<D>& grey, const std::optional<GreyRange>& range,
                       const EvolutionOptions& options, const std::string& where, const Progress& progress = {},
                       const LevelSetObserver<D>& observer = {});

extern template Field<2> evolve_region(Field<2>, const Field<2>&, const std::optional<GreyRange>&,
                                       const EvolutionOptions&, const std::string&, const Progress&,
                                       const LevelSetObserver<2>&);
extern template Field<3> evolve_region(Field<3>, const Field<3>&, const std::optional<GreyRange>&,
                                       const EvolutionOptions&, const std::string&, const Progress&,
                                       const LevelSetObserver<3>&);

}  // namespace isostack
