#include "recon/morphing/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "recon/constraints/mesh_constraints.h"
#include "recon/distance/mended_mesh.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

std::string name_of(const KeyShape& shape) { return shape.name.empty() ? "shape" : shape.name; }

void require_figure(const std::string& name, const ContourSlice& figure) {
  const bool has_area = std::any_of(figure.contours.begin(), figure.contours.end(), [](const Contour& contour) {
    return contour.points_mm.size() >= 3 && std::abs(signed_area_mm2(contour)) > 0;
  });
  if (!has_area) throw InputError(name, "nothing in it is inside", "check the level or the label");
  for (const Contour& contour : figure.contours)
    for (const Eigen::Vector2d& point : contour.points_mm)
      if (!point.allFinite())
        throw InputError(name, "a contour has a point that is not a number", "write the contours again");
}

/// Rounded positions in files move poses by less than these.
constexpr double same_direction = 1e-3, same_spacing = 1e-3, same_plane_pixels = 0.01;

void require_same_frame(const std::string& name, const SlicePose& pose, const std::string& first_name,
                        const SlicePose& first) {
  if ((pose.x_axis - first.x_axis).norm() > same_direction || (pose.y_axis - first.y_axis).norm() > same_direction)
    throw InputError(name, fmt::format("its axes point another way than those of {}", first_name),
                     "morph figures of one plane and orientation");
  if (((pose.spacing_mm - first.spacing_mm).array().abs() > same_spacing * first.spacing_mm.array()).any())
    throw InputError(
        name,
        fmt::format("its pixels are {:.4g} x {:.4g} mm, those of {} are {:.4g} x {:.4g} mm", pose.spacing_mm.x(),
                    pose.spacing_mm.y(), first_name, first.spacing_mm.x(), first.spacing_mm.y()),
        "resample one of them to the pixels of the other");
  const double off_mm = first.signed_distance_mm(pose.origin_mm);
  if (std::abs(off_mm) > same_plane_pixels * first.spacing_mm.minCoeff())
    throw InputError(name, fmt::format("its plane is {:.4g} mm off that of {}", off_mm, first_name),
                     "move both into one plane; slices at their own places are what `reconstruct` is for");
}

void require_image(const KeyShape& shape, const ContourSlice& figure) {
  if (!shape.image) return;
  const Image<float>& pixels = shape.image->pixels;
  if (pixels.size() == 0) throw InputError(name_of(shape), "its image has no pixels", "give another image");
  if (figure.size_pixels.minCoeff() > 0 &&
      (pixels.cols() != figure.size_pixels.x() || pixels.rows() != figure.size_pixels.y()))
    throw InputError(name_of(shape), "its image and its contours have different sizes", "trace the contours again");
}

}  // namespace

int dimension_of(const Shape& shape) { return std::holds_alternative<ContourSlice>(shape) ? 2 : 3; }

void require_morphable(const std::vector<KeyShape>& shapes) {
  if (shapes.size() < 2)
    throw InputError(shapes.empty() ? "morph" : name_of(shapes.front()), "a morph needs two shapes or more",
                     "give another shape");
  const KeyShape& first = shapes.front();
  for (const KeyShape& shape : shapes) {
    if (dimension_of(shape.shape) != dimension_of(first.shape))
      throw InputError(name_of(shape),
                       fmt::format("it is a {}, but {} is not",
                                   dimension_of(shape.shape) == 2 ? "figure in a plane" : "body", name_of(first)),
                       "morph figures into figures and bodies into bodies");
    if (const auto* figure = std::get_if<ContourSlice>(&shape.shape)) {
      require_figure(name_of(shape), *figure);
      require_same_frame(name_of(shape), figure->pose, name_of(first), std::get<ContourSlice>(first.shape).pose);
      require_image(shape, *figure);
    } else {
      TriangleMesh named = std::get<TriangleMesh>(shape.shape);
      named.name = name_of(shape);
      require_closed(named);
    }
  }
}

void require_distances(const std::vector<KeyShape>& shapes) {
  for (const KeyShape& shape : shapes) {
    if (dimension_of(shape.shape) == 2) continue;
    TriangleMesh named = std::get<TriangleMesh>(shape.shape);
    named.name = name_of(shape);
    require_no_overlap(named);
  }
}

Eigen::AlignedBox3d box_of(const Shape& shape, const SlicePose& pose) {
  Eigen::AlignedBox3d box;
  if (const auto* mesh = std::get_if<TriangleMesh>(&shape)) {
    for (const Eigen::Vector3d& vertex : mesh->vertices_mm) box.extend(vertex);
    return box;
  }
  const auto& figure = std::get<ContourSlice>(shape);
  for (const Contour& contour : figure.contours)
    for (const Eigen::Vector2d& point : contour.points_mm) {
      const Eigen::Vector2d there = pose.world_to_slice(figure.pose.slice_to_world(point));
      box.extend(Eigen::Vector3d(there.x(), there.y(), 0));
    }
  return box;
}

SlicePose common_pose(const std::vector<KeyShape>& shapes) {
  const auto* figure = std::get_if<ContourSlice>(&shapes.front().shape);
  return figure != nullptr ? figure->pose : SlicePose{};
}

Eigen::AlignedBox3d box_of(const std::vector<KeyShape>& shapes) {
  Eigen::AlignedBox3d box;
  for (const KeyShape& shape : shapes) box.extend(box_of(shape.shape, common_pose(shapes)));
  return box;
}

}  // namespace isostack
