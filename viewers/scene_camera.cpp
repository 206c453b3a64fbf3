#include "viewers/scene_camera.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr double wider = 1.15;  ///< of the width more is filled: title, scale bar and marker are above and below

/// Columns: right, up and towards the viewer.
Eigen::Matrix3d view_axes(const Eigen::Vector3d& view_from, const std::optional<Eigen::Vector3d>& view_up) {
  if (!view_from.allFinite() || view_from.norm() < 1e-9)
    throw InputError("view", "the viewing direction has no length", "give a direction such as 0.5,-0.9,0.35");
  const Eigen::Vector3d towards_viewer = view_from.normalized();
  const bool along_body = std::abs(towards_viewer.z()) > 0.999;
  const Eigen::Vector3d body_up = along_body ? Eigen::Vector3d(0, -1, 0) : Eigen::Vector3d(0, 0, 1);
  const Eigen::Vector3d up = view_up.value_or(body_up);
  Eigen::Matrix3d axes;
  axes.col(0) = up.cross(towards_viewer).normalized();
  axes.col(1) = towards_viewer.cross(axes.col(0));
  axes.col(2) = towards_viewer;
  return axes;
}

}  // namespace

void aim_camera(const std::vector<Eigen::Vector3d>& points_mm, const SceneLook& look, double free_share,
                vtkRenderer& renderer) {
  const Eigen::Matrix3d axes = view_axes(look.view_from, look.view_up);
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
  const double height_mm = size_mm.y() / look.filled;
  const double width_mm = size_mm.x() / (std::min(1.0, wider * look.filled) * free_share);
  camera.SetParallelScale(std::max(height_mm, width_mm / aspect) / 2);
  camera.SetWindowCenter(1 - free_share, 0);
  renderer.ResetCameraClippingRange();
}

}  // namespace isostack
