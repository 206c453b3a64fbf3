#include "segmentation/shape_steps.h"

#include <cmath>
#include <limits>
#include <utility>

#include "segmentation/convex_hull.h"
#include "segmentation/fast_marching.h"
#include "segmentation/gaussian_filter.h"
#include "segmentation/offset_motion.h"
#include "segmentation/region.h"

namespace isostack {

namespace {

/// Distances are kept this far from the curve: enough for tracing and for set operations.
constexpr double band_pixels = 4;

Eigen::Vector2i size_of(const Image<float>& image) {
  return {static_cast<int>(image.cols()), static_cast<int>(image.rows())};
}

void combine(const SolidStep& step, const SlicePose& pose, Image<float>& phi) {
  const Image<float> solid = signed_distance_mm(step.solid, pose, size_of(phi));
  Field<2> field = field_of(phi, pose.spacing_mm);
  redistance(field, band_pixels * field.smallest_spacing_mm());
  phi = image_of(field);
  switch (step.operation) {
    case SolidStep::Operation::add:
      phi = phi.max(solid);
      break;
    case SolidStep::Operation::keep:
      phi = phi.min(solid);
      break;
    case SolidStep::Operation::remove:
      phi = phi.min(-solid);
      break;
  }
}

/// The step as a motion by distances; false when it is none.
template <int D>
bool move(const StartStep& step, Field<D>& field) {
  const double band_mm = band_pixels * field.smallest_spacing_mm();
  if (const auto* grow = std::get_if<GrowStep>(&step))
    field = offset_region(std::move(field), grow->distance_mm, band_mm);
  else if (const auto* open = std::get_if<OpenStep>(&step))
    field = open_region(std::move(field), open->radius_mm, band_mm);
  else if (const auto* close = std::get_if<CloseStep>(&step))
    field = close_region(std::move(field), close->radius_mm, band_mm);
  else
    return false;
  return true;
}

bool is_motion(const StartStep& step) {
  return std::holds_alternative<GrowStep>(step) || std::holds_alternative<OpenStep>(step) ||
         std::holds_alternative<CloseStep>(step);
}

}  // namespace

void apply_filter(const StartStep& step, const Eigen::Vector2d& spacing_mm, Image<float>& grey) {
  if (const auto* gaussian = std::get_if<GaussianStep>(&step))
    grey = gaussian_filter_mm(grey, gaussian->sigma_pixels * spacing_mm.minCoeff(), spacing_mm);
  else if (const auto* diffusion = std::get_if<DiffusionStep>(&step))
    grey = anisotropic_diffusion(grey, spacing_mm, diffusion->options);
}

void apply_shape_step(const StartStep& step, const SlicePose& pose, Image<float>& phi) {
  if (const auto* solid = std::get_if<SolidStep>(&step)) {
    combine(*solid, pose, phi);
  } else if (std::holds_alternative<FillHolesStep>(step)) {
    impose(fill_holes(inside_of(phi)), phi);
  } else if (std::holds_alternative<HullStep>(step)) {
    phi = hull_of_parts(phi, pose.spacing_mm);
  } else if (is_motion(step)) {
    Field<2> field = field_of(phi, pose.spacing_mm);
    move(step, field);
    phi = image_of(field);
  }
}

void apply_shape_step(const StartStep& step, const std::vector<SlicePose>& poses, double plane_distance_mm,
                      std::vector<Image<float>>& phi) {
  if (is_motion(step)) {
    const Eigen::Vector2d& pixel = poses.front().spacing_mm;
    Field<3> field = field_of(phi, {pixel.x(), pixel.y(), plane_distance_mm});
    move(step, field);
    phi = planes_of(field);
    return;
  }
  for (std::size_t k = 0; k < phi.size(); ++k) apply_shape_step(step, poses[k], phi[k]);
}

Image<float> region_of_labels(const LabelStep& step, const SlicePose& pose, const Eigen::Vector2i& size_pixels) {
  const Grid& grid = step.labels->grid;
  const Eigen::Affine3d world_to_index = grid.index_to_world.inverse();
  const auto depth = static_cast<float>(pose.spacing_mm.minCoeff() / 2);
  Image<float> region = Image<float>::Constant(size_pixels.y(), size_pixels.x(), -depth);
  for (int row = 0; row < size_pixels.y(); ++row)
    for (int column = 0; column < size_pixels.x(); ++column) {
      const Eigen::Vector3d index = world_to_index * pose.pixel_to_world({column, row});
      const Eigen::Vector3i voxel = index.array().round().cast<int>();
      if ((voxel.array() < 0).any() || (voxel.array() >= grid.size.array()).any()) continue;
      const float value = step.labels->at(voxel.x(), voxel.y(), voxel.z());
      if (step.label == 0 ? value != 0 : value == static_cast<float>(step.label)) region(row, column) = depth;
    }
  return region;
}

}  // namespace isostack
