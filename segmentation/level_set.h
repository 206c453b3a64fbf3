#pragma once

#include <limits>
#include <vector>

#include "segmentation/field.h"
#include "segmentation/speed_terms.h"

namespace isostack {

/// Lengths in pixels refer to the smallest spacing.
struct LevelSetOptions {
  int max_steps = 100;                                           ///< at most this many steps
  double max_time_mm = std::numeric_limits<double>::infinity();  ///< stop exactly at this time
  double tolerance_pixels = 1e-3;  ///< stop when the curve's RMS movement in one step falls below; 0: never
  double band_pixels = 6;          ///< φ is evolved up to this distance from the curve
  double cfl = 0.8;                ///< share of the largest stable time step, in (0, 1]
};

enum class LevelSetStop { converged, max_steps, max_time, no_curve };

template <int D>
struct LevelSetResult {
  Field<D> phi;  ///< signed distance in mm, positive inside, ±(band + 2 pixels) beyond the band
  int steps = 0;
  double time_mm = 0;
  double rms_change_pixels = 0;                ///< RMS movement of the curve in the last step
  LevelSetStop stop = LevelSetStop::no_curve;  ///< why it stopped; no_curve: φ has one sign everywhere
};

/// Evolves φ_t = |∇φ| F (Breen et al. 2001, eq. 5) where F is the sum of the terms, from the zero set of `phi`
/// (inside where phi >= 0, any scale). Explicit steps in a narrow band: Godunov's upwind scheme for propagation with
/// the speed at the closest point of the curve, central differences for curvature, step bounded by the CFL
/// condition; φ is made a signed distance again (fast marching) whenever a value has changed by a pixel.
/// The curve moves, so a term does not make new curves away from it. Serial and deterministic.
template <int D>
LevelSetResult<D> evolve(Field<D> phi, const std::vector<SpeedTerm<D>*>& terms, const LevelSetOptions& options = {});

extern template LevelSetResult<2> evolve(Field<2>, const std::vector<SpeedTerm<2>*>&, const LevelSetOptions&);
extern template LevelSetResult<3> evolve(Field<3>, const std::vector<SpeedTerm<3>*>&, const LevelSetOptions&);

}  // namespace isostack
