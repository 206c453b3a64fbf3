#pragma once

#include <vector>

#include "recon/subdivision/figure_interpolator.h"
#include "recon/subdivision/multiresolution_fit.h"

namespace isostack {

/// What the interpolator of figures is optimised for: all places of the sources held at every level, and those of
/// topological key shapes at levels 0 and 1 alone, so that these say roughly where parts are and fine levels smooth it.
/// The reference is the straight blend of polygons that go half-way between a source's details. With `lingering` these
/// are added: a vertex with the base weights β is where these weights lead to on the one source and on the other, in
/// proportion to each share.
FitProblem figure_problem(const FigureInterpolator& figures, int levels, bool lingering);

}  // namespace isostack
