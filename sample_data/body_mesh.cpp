#include "sample_data/body_mesh.h"

#include "recon/surface/extract_surface.h"

namespace isostack {

namespace {

ScalarField field_of(const Body& body) {
  ScalarField field;
  field.values = [&body](const Eigen::Matrix3Xd& points) {
    Eigen::VectorXd values(points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) values[i] = body.depth_mm(points.col(i));
    return values;
  };
  field.gradients = [&body](const Eigen::Matrix3Xd& points) {
    constexpr double step_mm = 1e-4;
    Eigen::Matrix3Xd gradients(3, points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d step = step_mm * Eigen::Vector3d::Unit(axis), point = points.col(i);
        gradients(axis, i) = (body.depth_mm(point + step) - body.depth_mm(point - step)) / (2 * step_mm);
      }
    return gradients;
  };
  return field;
}

/// A place on the surface, found on a line from far outside to the middle of the body or through it.
Eigen::Vector3d seed_of(const Body& body, const Eigen::AlignedBox3d& bounds_mm) {
  Eigen::Vector3d point = bounds_mm.center() + Eigen::Vector3d(bounds_mm.sizes().x() / 2, 0.3, 0.2);
  while (body.depth_mm(point) < 0) point.x() -= 0.05;
  return point;
}

}  // namespace

TriangleMesh mesh_of(const Body& body, const Eigen::AlignedBox3d& bounds_mm, double cell_mm) {
  ExtractionOptions options;
  options.resolution_mm = cell_mm;
  options.bounds = bounds_mm;
  TriangleMesh mesh = extract_surface(field_of(body), {seed_of(body, bounds_mm)}, options).mesh;
  mesh.name = body.name;
  return mesh;
}

}  // namespace isostack
