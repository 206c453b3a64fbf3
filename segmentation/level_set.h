#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "recon/geometry/progress.h"
#include "segmentation/field.h"
#include "segmentation/speed_terms.h"

namespace isostack {

/// All that tracing contours needs. A result of no more than this width costs nothing: it is what the evolution keeps
/// around the curve, a distance within about a tenth of a pixel. A wider one is made by redistance.
template <int D>
constexpr double narrow_band_pixels = D == 2 ? 2 : 1.7;

/// Lengths in pixels refer to the smallest spacing.
struct LevelSetOptions {
  int max_steps = 100;                                           ///< at most this many steps
  double max_time_mm = std::numeric_limits<double>::infinity();  ///< stop exactly at this time
  double tolerance_pixels = 1e-3;  ///< stop when the curve's RMS movement in one step falls below; 0: never
  double band_pixels = 6;          ///< the result is a distance up to here, see narrow_band_pixels
  double cfl = 0.8;                ///< share of the largest stable time step, in (0, 1]
};

enum class LevelSetStop {
  converged,  ///< the curve rests within the tolerance
  max_steps,
  max_time,
  vanished,   ///< no node is inside (any more)
  flooded,    ///< no node is outside (any more)
  observed,   ///< the observer had seen enough
  not_finite  ///< a term gave NaN or infinity next to the curve; phi is that before the step
};

template <int D>
struct LevelSetResult {
  Field<D> phi;  ///< signed distance in mm, positive inside, ± the band beyond it
  int steps = 0;
  double time_mm = 0;
  double rms_change_pixels = 0;                ///< RMS movement of the curve in the last step
  LevelSetStop stop = LevelSetStop::vanished;  ///< why it stopped
};

/// An evolution before its first step or after one.
template <int D>
struct LevelSetState {
  const Field<D>& phi;                           ///< a distance within two nodes of the curve, elsewhere a sign
  const std::vector<std::size_t>& beside_curve;  ///< the nodes with a neighbour on the other side
  double time_mm;
};

/// Called for every state, from the thread that called evolve; false ends the evolution with that state.
template <int D>
using LevelSetObserver = std::function<bool(const LevelSetState<D>&)>;

/// Evolves φ_t = |∇φ| F (Breen et al. 2001, eq. 5), F = Σ weight · term, from the zero set of `phi` (inside where
/// phi >= 0, any scale), by a sparse field (Whitaker 1998): F is computed at the nodes next to the curve only and
/// carried along the normal to two layers of neighbours; the step is bounded by the CFL condition. φ stays a distance
/// because it changes by the curve's own movement (∇F·∇φ = 0, Adalsteinsson and Sethian 1999), and nodes the curve
/// comes near to, or that have changed by a pixel, get theirs anew from Godunov's second-order upwind scheme for |∇φ|
/// = 1. The curve moves, so a term does not make new curves away from it. The result is the same on any number of
/// threads. Memory: two 4-byte values per node besides the terms' images, and about 60 bytes per node of the band.
/// Reports after every step. Throws InputError on spacings that are not positive and on values that are not finite in
/// `phi`, Cancelled when `progress` says so.
template <int D>
LevelSetResult<D> evolve(Field<D> phi, const std::vector<WeightedTerm<D>>& terms, const LevelSetOptions& options = {},
                         const Progress& progress = {}, const LevelSetObserver<D>& observer = {});

extern template LevelSetResult<2> evolve(Field<2>, const std::vector<WeightedTerm<2>>&, const LevelSetOptions&,
                                         const Progress&, const LevelSetObserver<2>&);
extern template LevelSetResult<3> evolve(Field<3>, const std::vector<WeightedTerm<3>>&, const LevelSetOptions&,
                                         const Progress&, const LevelSetObserver<3>&);

}  // namespace isostack
