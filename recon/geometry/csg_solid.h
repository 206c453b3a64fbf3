#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace isostack {

/// A constructive solid: a superellipsoid, or a set operation on solids. World LPS mm.
struct CsgSolid {
  enum class Kind {
    superellipsoid,
    set_union,
    intersection,
    difference  ///< the first part without the others
  };
  std::string name;  ///< names the solid in messages
  Kind kind = Kind::superellipsoid;
  std::vector<CsgSolid> parts;  ///< of a set operation, one or more

  /// Of a superellipsoid (Barr 1981): ((|x/a1|^(2/e2) + |y/a2|^(2/e2))^(e2/e1) + |z/a3|^(2/e1)) <= 1 in its own axes.
  Eigen::Vector3d radii_mm = Eigen::Vector3d::Ones();  ///< a1, a2, a3 > 0
  Eigen::Vector2d exponents =
      Eigen::Vector2d::Ones();  ///< e1 (north-south), e2 (east-west), in [0.1, 2]: 1 round, near 0 square, 2 octahedral
  Eigen::Affine3d to_world = Eigen::Affine3d::Identity();  ///< from its own axes; invertible
};

}  // namespace isostack
