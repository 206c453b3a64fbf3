#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/subdivision/simplicial_mesh.h"

namespace isostack {

/// What lies on a section counts as beyond it, so that no section meets a vertex, and the sections of a manifold are
/// closed manifolds whatever its vertices' positions.
enum class OnSection {
  beyond,  ///< a vertex with the value 0 is after the section: at the last source's time the section is that source
  before   ///< it is before it: at the first source's time the section is that source
};

/// Where a function with these values at the vertices, linear in every simplex, is 0: t(vertex) minus a constant
/// (Ohbuchi, Kokojima & Takahashi 2001, Section 2, shape extraction), or minus a function of the place. Triangles in
/// (x, y, t), outside out, give closed curves with the inside to their left, mended where they cross (figure_of()).
/// Points that coincide because a vertex lies on the section are one.
std::vector<Contour> section_contours(const SimplicialMesh& mesh, const Eigen::VectorXd& values,
                                      OnSection on = OnSection::beyond);

/// The same of tetrahedra in (x, y, z, t): a closed mesh. A tetrahedron (a, b, c, d) is oriented so that, with a before
/// the section and b, c, d after it, the triangle of the points on ab, ac, ad runs counter-clockwise seen from outside.
TriangleMesh section_mesh(const SimplicialMesh& mesh, const Eigen::VectorXd& values, OnSection on = OnSection::beyond);

/// The values for t = const.
Eigen::VectorXd values_at_time(const SimplicialMesh& mesh, double t_mm);

}  // namespace isostack
