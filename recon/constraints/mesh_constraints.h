#pragma once

#include <vector>

#include "recon/constraints/constraint_set.h"
#include "recon/constraints/mesh_samples.h"
#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Boundary constraints of value 0 and normal constraints off them, in world mm, f > 0 inside.
struct MeshConstraintOptions {
  double offset_mm = 1;      ///< distance of the normal constraints; less where the body or a gap is thin
  bool as_in_paper = false;  ///< one normal constraint of value 1, inside at the whole offset (Turk & O'Brien, §4.2)
};

/// Samples first, then a partner inside and one outside of each sample, whose values are their signed distances to the
/// mesh; none where the body or gap is thinner than some twentieth of the offset. Deterministic.
ConstraintSet mesh_constraints(const TriangleMesh& mesh, const std::vector<MeshSample>& samples,
                               const MeshConstraintOptions& options);

}  // namespace isostack
