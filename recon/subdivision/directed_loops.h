#pragma once

#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// The figure that directed loops mean, the inside to their left: what they run round counter-clockwise more often than
/// clockwise. Loops that neither cross nor lie where they change nothing come back as they are, with their depths; a
/// hole that has left its figure is dropped, and what crosses is cut there (simple_loops.h).
std::vector<Contour> figure_of(std::vector<Contour> directed);

/// A place where edges of the two contours cross properly, touching left out.
bool cross_each_other(const Contour& one, const Contour& other);

}  // namespace isostack
