#pragma once

#include <Eigen/Core>
#include <memory>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// The generalised winding number of a triangle soup (Jacobson, Kavan, Sorkine-Hornung 2013): 1 inside a closed mesh
/// with the outside out, 0 outside, in between near holes. Triangles far off count as one dipole per box (Barill et al.
/// 2018, first order): errors of some 1e-2. May be asked from several threads at once.
class WindingNumber {
 public:
  explicit WindingNumber(const TriangleMesh& mesh);
  double at(const Eigen::Vector3d& point_mm) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

}  // namespace isostack
