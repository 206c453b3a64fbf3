#pragma once

#include <Eigen/Core>
#include <optional>

#include "recon/geometry/contour.h"

namespace isostack {

/// A point (slice mm) where two edges of the contour cross properly; nothing for a simple curve. Edges that only touch,
/// or run along each other as the two sides of a keyhole do, do not cross.
std::optional<Eigen::Vector2d> self_crossing(const Contour& contour);

}  // namespace isostack
