#include "viewers/scene_camera.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr double filled_height = 0.80;  // leaves room for the title above, scale bar and marker below
constexpr double filled_width = 0.92;

/// Columns: right, up and towards the viewer.
Eigen::Matrix3d view_axes(const Eigen::Vector3d& view_from) {
  if (!view_from.allFinite() || view_from.norm() < 1e-9)
    throw InputError("view", "the viewing direction has no length", "give a direction such as 0.5,-0.9,0.35");
  const Eigen::Vector3d towards_viewer = view_from.normalized();
  const bool along_body = std::abs(towards_viewer.z()) > 0.999;
  const Eigen::Vector3d up = along_body ? Eigen::Vector3d(0, -1, 0) : Eigen::Vector3d(0, 0, 1);
  Eigen::Matrix3d axes;
  axes.col(0) = up.cross(towards_viewer).normalized();
  axes.col(1) = towards_viewer.cross(axes.col(0));
  axes.col(2) = towards_viewer;
  return axes;
}

}  // namespace

void aim_camera(const std::vector<Eigen::Vector3d>& points_mm, const Eigen::Vector3d& view_from,
                vtkRenderer& renderer) {
  const Eigen::Matrix3d axes = view_axes(view_from);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points_mm) box.extend(axes.transpose() * point);
  const Eigen::Vector3d size_mm = box.sizes().cwiseMax(1e-3);
  const Eigen::Vector3d centre = axes * box.center();
  const Eigen::Vector3d position = centre + axes.col(2) * 2 * size_mm.norm();
  renderer.ComputeAspect();
  const double aspect = renderer.GetAspect()[0] / renderer.GetAspect()[1];

  vtkCamera& camera = *renderer.GetActiveCamera();
  camera.ParallelProjectionOn();
  camera.SetFocalPoint(centre.data());
  camera.SetPosition(position.data());
  camera.SetViewUp(axes.col(1).eval().data());
  camera.SetParallelScale(std::max(size_mm.y() / filled_height, size_mm.x() / filled_width / aspect) / 2);
  renderer.ResetCameraClippingRange();
}

}  // namespace isostack
