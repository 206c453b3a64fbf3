#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// A function of the plane that is positive inside, evaluated in batches. Points are 2 × M, mm.
using PlaneFunction = std::function<Eigen::VectorXd(const Eigen::Matrix2Xd&)>;

/// Nodes with the same distance along both axes.
struct PlaneLattice {
  Eigen::Vector2d first_mm = Eigen::Vector2d::Zero();
  double spacing_mm = 1;
  Eigen::Vector2i size = Eigen::Vector2i::Zero();  ///< along x and y
};

/// Covers the box and at least two more nodes on every side. Nodes keep off round coordinates, where figures drawn by
/// hand have their corners and edges. Throws GeometryError for more than 10⁸ nodes.
PlaneLattice lattice_over(const Eigen::AlignedBox2d& box_mm, double spacing_mm);

/// All nodes, x fastest: 2 × (size.x · size.y).
Eigen::Matrix2Xd nodes_of(const PlaneLattice& lattice);

/// The closed curves on which the function is 0, the inside to the left, with nesting depths. `node_values` are the
/// function at nodes_of(lattice). Where marching squares cross a line of the lattice the root is found, and further
/// points on the curve are added until its chords stay within `deviation_mm`. What is smaller than the lattice's
/// spacing may be missed. Outside the lattice is outside: there curves close half a step beyond its nodes.
std::vector<Contour> zero_contours(const PlaneFunction& function, const PlaneLattice& lattice,
                                   const Eigen::VectorXd& node_values, double deviation_mm);

/// Whether a node on the lattice's rim is inside: the figure is cut there.
bool is_cut(const PlaneLattice& lattice, const Eigen::VectorXd& node_values);

}  // namespace isostack
