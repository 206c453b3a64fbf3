#pragma once

#include <Eigen/Core>

#include "recon/surface/editable_mesh.h"

namespace isostack {

/// How far a vertex may move without the surface losing a crease: in the tangent plane, along one line, or not at all.
enum class Freedom { none, line, plane };

struct Crease {
  Freedom freedom;
  Eigen::Vector3d along;  ///< the line's direction (unit), where there is one
};

/// By the spread of the triangles' directions round v (normal tensor voting, Medioni, Lee & Tang 2000): a crease is
/// where two sides meet at more than some 35°.
Crease crease_at(const EditableMesh& mesh, int v);

}  // namespace isostack
