#include "recon/distance/distance_surface.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "recon/geometry/errors.h"
#include "recon/surface/extract_surface.h"
#include "recon/surface/surface_seeds.h"

namespace isostack {

namespace {

using Eigen::Vector3d;

/// The volume in mm along its own axes, its first voxel at 0.
class OwnAxes {
 public:
  explicit OwnAxes(const Volume<float>& volume)
      : volume_(volume),
        spacing_mm_(Eigen::Matrix3d(volume.grid.index_to_world.linear()).colwise().norm().transpose()) {}

  const Vector3d& spacing_mm() const { return spacing_mm_; }

  struct Sample {
    double value;
    Vector3d gradient;
  };

  Sample at(const Vector3d& point_mm) const {
    Eigen::Vector3i cell;
    Vector3d share;
    for (int axis = 0; axis < 3; ++axis) {
      const int last = volume_.grid.size[axis] - 1;
      const double index = std::clamp(point_mm[axis] / spacing_mm_[axis], 0.0, static_cast<double>(last));
      cell[axis] = std::min(static_cast<int>(index), last - 1);
      share[axis] = index - cell[axis];
    }
    Sample sample{0, Vector3d::Zero()};
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3i up(corner & 1, corner >> 1 & 1, corner >> 2);
      const Vector3d weight = up.cast<double>().cwiseProduct(share) +
                              (1 - up.cast<double>().array()).matrix().cwiseProduct(Vector3d::Ones() - share);
      const Eigen::Vector3i node = cell + up;
      const auto value = static_cast<double>(volume_.at(node.x(), node.y(), node.z()));
      sample.value += value * weight.prod();
      for (int axis = 0; axis < 3; ++axis)
        sample.gradient[axis] +=
            value * (up[axis] != 0 ? 1 : -1) / spacing_mm_[axis] * weight[(axis + 1) % 3] * weight[(axis + 2) % 3];
    }
    return sample;
  }

  ScalarField field() const {
    ScalarField field;
    field.values = [this](const Eigen::Matrix3Xd& points) {
      Eigen::VectorXd values(points.cols());
      tbb::parallel_for(Eigen::Index{0}, points.cols(), [&](Eigen::Index n) { values[n] = at(points.col(n)).value; });
      return values;
    };
    field.gradients = [this](const Eigen::Matrix3Xd& points) {
      Eigen::Matrix3Xd gradients(3, points.cols());
      tbb::parallel_for(Eigen::Index{0}, points.cols(),
                        [&](Eigen::Index n) { gradients.col(n) = at(points.col(n)).gradient; });
      return gradients;
    };
    return field;
  }

 private:
  const Volume<float>& volume_;
  Vector3d spacing_mm_;
};

bool is_inside_along_its_border(const Volume<float>& distance_mm) {
  const Eigen::Vector3i last = distance_mm.grid.size.array() - 1;
  for (int z = 0; z <= last.z(); ++z)
    for (int y = 0; y <= last.y(); ++y) {
      const bool whole_row = z == 0 || z == last.z() || y == 0 || y == last.y();
      for (int x = 0; x <= last.x(); x += whole_row ? 1 : last.x())
        if (!(distance_mm.at(x, y, z) > 0)) return false;
    }
  return true;
}

}  // namespace

TriangleMesh distance_surface(const Volume<float>& distance_mm, const DistanceSurfaceOptions& options,
                              const Progress& progress) {
  const Grid& grid = distance_mm.grid;
  const Eigen::Matrix3d axes_mm = grid.index_to_world.linear();
  if (grid.size.minCoeff() < 2 || !(std::abs(axes_mm.determinant()) > 0))
    throw GeometryError("distance volume", "it has fewer than two voxels along an axis", "give a whole volume");
  const OwnAxes own(distance_mm);
  ExtractionOptions extraction;
  extraction.resolution_mm = options.resolution_mm > 0 ? options.resolution_mm : own.spacing_mm().minCoeff();
  extraction.bounds = Eigen::AlignedBox3d(
      Vector3d::Zero(), own.spacing_mm().cwiseProduct((grid.size.array() - 1).matrix().cast<double>()));
  const ScalarField field = own.field();
  const std::vector<Vector3d> seeds = surface_seeds(field, extraction.bounds, extraction.resolution_mm);
  if (seeds.empty())
    throw GeometryError("distance volume", "all its values have one sign", "give a volume that is positive inside");
  if (is_inside_along_its_border(distance_mm))
    throw GeometryError("distance volume", "it is positive, thus inside, along its whole border",
                        "turn its sign round (--distances outside) if it is positive outside, else give a larger one");
  TriangleMesh mesh = extract_surface(field, seeds, extraction, progress).mesh;

  const Eigen::Matrix3d to_world = axes_mm * own.spacing_mm().cwiseInverse().asDiagonal();
  const Eigen::Matrix3d normals_to_world = to_world.inverse().transpose();
  for (Vector3d& v : mesh.vertices_mm) v = (to_world * v + grid.index_to_world.translation()).eval();
  for (Vector3d& n : mesh.normals) n = (normals_to_world * n).normalized().eval();
  if (to_world.determinant() < 0)
    for (Eigen::Vector3i& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace isostack
