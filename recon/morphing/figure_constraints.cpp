#include <algorithm>
#include <cmath>
#include <vector>

#include "recon/constraints/contour_constraints.h"
#include "recon/constraints/contour_samples.h"
#include "recon/constraints/image_constraints.h"
#include "recon/geometry/pixel_lattice.h"
#include "recon/morphing/densified.h"
#include "recon/morphing/signed_distance_stack.h"
#include "recon/morphing/solved_morph.h"

namespace isostack {

namespace {

/// Samples beside the corners between long edges: at an even spacing alone the solved function would round them off by
/// a good part of it.
void add_corner_samples(const std::vector<Contour>& contours, double step_mm, std::vector<ContourSample>& samples) {
  constexpr double least_turn = 0.5;  // radians
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const auto& points = contours[c].points_mm;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d back = points[(i + points.size() - 1) % points.size()] - points[i];
      const Eigen::Vector2d ahead = points[(i + 1) % points.size()] - points[i];
      if (std::min(back.norm(), ahead.norm()) < 2 * step_mm) continue;
      const double turn = std::acos(std::clamp(-back.normalized().dot(ahead.normalized()), -1.0, 1.0));
      if (turn < least_turn) continue;
      for (const double share : {0.25, 0.5})
        for (const Eigen::Vector2d& along : {Eigen::Vector2d(-back), ahead}) {
          const double sign = along == ahead ? 1 : -1;
          const Eigen::Vector2d way = along.normalized();
          samples.push_back({0, c, points[i] + sign * share * step_mm * way, {-way.y(), way.x()}});
        }
    }
  }
}

/// Signed distances in mm, as for a reconstruction from this one slice.
ShapeConstraints signed_figure(const std::string& name, std::vector<Contour> contours, const SlicePose& pose,
                               const VariationalMorphOptions& options, std::size_t most) {
  orient_by_nesting(contours);
  const double step_mm = options.sample_spacing_pixels * pose.spacing_mm.minCoeff();
  const SlicePose plane{.spacing_mm = pose.spacing_mm};  // slice coordinates are world coordinates there
  const ContourStack alone{.name = name,
                           .slices = {{.name = name, .pose = plane, .contours = densified(contours, step_mm)}}};
  std::vector<ContourSample> samples =
      sample_contours(alone, {.max_samples = most / 3, .min_spacing_pixels = options.sample_spacing_pixels});
  add_corner_samples(contours, step_mm, samples);
  const ContourConstraints built = signed_constraints(alone, samples, {.offset_pixels = options.offset_pixels});
  return {{built.constraints.points.topRows(2), built.constraints.values, {}},
          static_cast<Eigen::Index>(built.samples.size())};
}

/// White inside, black outside, and grey within a pixel of the curves, so that half grey lies on them.
Slice drawn(const ContourSlice& figure) {
  const PixelLattice lattice = lattice_of(figure, {.name = figure.name, .slices = {figure}});
  const auto ramp_mm = static_cast<float>(2 * lattice.pose.spacing_mm.maxCoeff());
  const Image<float> distance_mm = signed_distance_image(figure.contours, figure.pose, lattice);
  return {figure.name, lattice.pose, (distance_mm / ramp_mm + 0.5f).max(0.0f).min(1.0f)};
}

/// The paper's §4.1, from the figure's own picture where it has one.
ShapeConstraints paper_figure(const KeyShape& shape, const SlicePose& pose, std::size_t most) {
  const auto& figure = std::get<ContourSlice>(shape.shape);
  const Slice image = shape.image ? Slice{shape.name, figure.pose, shape.image->pixels} : drawn(figure);
  const SliceStack alone{.name = shape.name, .slices = {image}, .warnings = {}};
  const ConstraintSet world = image_constraint_set(alone, shape.image ? shape.image->level : 0.5, most);
  ShapeConstraints result{{Eigen::MatrixXd(2, world.points.cols()), world.values, {}}, world.values.size() / 2};
  for (Eigen::Index i = 0; i < world.points.cols(); ++i)
    result.set.points.col(i) = pose.world_to_slice(world.points.col(i));
  return result;
}

}  // namespace

ShapeConstraints figure_constraints(const KeyShape& figure, const SlicePose& pose,
                                    const VariationalMorphOptions& options, std::size_t most) {
  if (options.recipe == MorphRecipe::turk_obrien) return paper_figure(figure, pose, most);
  const auto& slice = std::get<ContourSlice>(figure.shape);
  return signed_figure(figure.name, moved_to(pose, slice.contours, slice.pose), pose, options, most);
}

}  // namespace isostack
