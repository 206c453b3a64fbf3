#pragma once

#include "recon/functions/solid_function.h"

namespace isostack {

/// Of one bounded blend (Pasko et al. 2004, equations 1 to 3).
struct BlendParameters {
  double a0 = 1;          ///< mm: displacement where both boundaries meet; ≥ 0, 0 is the plain set operation
  double a1 = 1, a2 = 1;  ///< > 0: how far from the first and the second solid the displacement reaches
  double a3 = 1;          ///< > 0: the smaller, the farther the displacement keeps its strength inside the bounds
};

/// Throws InputError when parameters are out of range.
void require_usable(const BlendParameters& parameters);

/// disp(r) = (1 − r²)³ / (1 + r²) for r < 1, otherwise 0, with r² = r1² / (r1² + r2²), r1² = (f1/a1)² + (f2/a2)² and
/// r2² = (f3/a3)² where f3 > 0; outside the bounds f3 it is 0. At most 1; a0 is not in it.
Eigen::ArrayXd blend_displacement(const Eigen::ArrayXd& f1, const Eigen::ArrayXd& f2, const Eigen::ArrayXd& f3,
                                  const BlendParameters& parameters);

/// f1 ∪ f2 with material added within the bounds: r_union(f1, f2) + a0 disp(r). Outside the bounds it is r_union.
SolidFunction bounded_blend_union(SolidFunction f1, SolidFunction f2, SolidFunction bounds,
                                  const BlendParameters& parameters);

/// f1 \ f2 with more taken away within the bounds: r_subtraction(f1, f2) − a0 disp(r).
SolidFunction bounded_blend_subtraction(SolidFunction f1, SolidFunction f2, SolidFunction bounds,
                                        const BlendParameters& parameters);

}  // namespace isostack
