#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/slice.h"
#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// A figure in a plane (what the contours of one slice enclose) or a body (closed mesh, world LPS mm).
using Shape = std::variant<ContourSlice, TriangleMesh>;

/// The picture a figure was drawn in: at least `level` is inside. Its pixels are those of the figure's pose.
struct GreyFigure {
  Image<float> pixels;
  double level = 0;
};

/// A given shape, which the morph takes on at its place.
struct KeyShape {
  std::string name;  ///< names the shape in messages
  Shape shape;
  std::optional<double> time = {};       ///< on a line: where, in any unit, ascending; all unset: evenly
  Eigen::VectorXd place = {};            ///< with KeyLayout::given: coordinates, in units of the morph's spacing
  std::optional<GreyFigure> image = {};  ///< of a figure: what the recipe `turk_obrien` takes its constraints from
};

/// 2 or 3.
int dimension_of(const Shape& shape);

/// Throws InputError naming the shape unless there are two or more, all figures of one plane with the same pixels'
/// axes and spacing, or all closed meshes with the outside out, and none is empty.
void require_morphable(const std::vector<KeyShape>& shapes);

/// Throws InputError, naming the shape and the place, when a body's parts overlap (require_no_overlap): for methods
/// that go by signed distances.
void require_distances(const std::vector<KeyShape>& shapes);

/// The pose that figures are morphed in, that of the first; world for bodies.
SlicePose common_pose(const std::vector<KeyShape>& shapes);

/// Box round a shape: in the slice coordinates of `pose` with z = 0 (figures), or in world mm (meshes).
Eigen::AlignedBox3d box_of(const Shape& shape, const SlicePose& pose);

/// Round all shapes, in their common pose.
Eigen::AlignedBox3d box_of(const std::vector<KeyShape>& shapes);

}  // namespace isostack
