#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "recon/subdivision/simplicial_mesh.h"

namespace isostack {

/// The shortest chain of edges, each of which rises in t, from one vertex to another: the geodesic on the interpolator
/// between two features, approximately (Ohbuchi et al. 2001, Section 2.4.1). None when no such chain leads there.
std::optional<std::vector<int>> rising_chain(const SimplicialMesh& mesh, int from, int to);

}  // namespace isostack
