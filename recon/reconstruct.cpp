#include "recon/reconstruct.h"

#include <algorithm>
#include <limits>

#include "recon/constraints/image_constraints.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/stopwatch.h"
#include "recon/metrics/input_sections.h"
#include "recon/organ_surface.h"
#include "recon/solve_steps.h"
#include "recon/solvers/interpolation_solver.h"
#include "recon/surface/implicit_function.h"

namespace isostack {

namespace {

std::vector<Eigen::Vector3d> leading_points(const ConstraintSet& set, Eigen::Index count) {
  std::vector<Eigen::Vector3d> points;
  for (Eigen::Index i = 0; i < count; ++i) points.emplace_back(set.points.col(i));
  return points;
}

}  // namespace

ReconstructOptions interpolating(ReconstructOptions options) {
  options.softening.strength = 0;
  options.sample_spacing_pixels = 0.2;
  options.section_tolerance_pixels = 0.1;
  options.section_rounds = 6;
  return options;
}

Reconstruction reconstruct(const ContourStack& contours, const ReconstructOptions& options, const Progress& progress) {
  OrganSurface organ = reconstruct_organ(contours, options, progress);
  retriangulate_organ(organ.bounded, options, progress, organ.result);
  organ.result.report.sections = agreement_at_inputs(organ.result.surface, contours);
  return std::move(organ.result);
}

Reconstruction reconstruct_turk_obrien(const SliceStack& images, double level, const ReconstructOptions& options,
                                       const Progress& progress) {
  Reconstruction result;
  const Stopwatch constraint_watch;
  const ConstraintSet set = image_constraint_set(images, level, options.max_constraints);
  const ConstraintSet all = image_constraint_set(images, level, std::numeric_limits<std::size_t>::max());
  const Eigen::Index pairs = set.values.size() / 2;
  result.report.contour_points = static_cast<std::size_t>(all.values.size() / 2);
  result.report.boundary_constraints = static_cast<std::size_t>(pairs);
  result.report.constraint_seconds = constraint_watch.seconds();
  require_two_slices(pairs > 0 ? images.slices.size() : 0, images.slices.size(), images.name);

  const Stopwatch solve_watch;
  const double pixel_mm = images.slices.front().pose.spacing_mm.minCoeff();
  InterpolationSolver solver(with_smoothing(set, options.smoothing), interpolation_options(options, pixel_mm),
                             progress);
  describe(solver, static_cast<std::size_t>(set.values.size()), result.report);
  SolveReport reached;
  const RadialWeights solution = solver.solve(set.values, {}, reached, progress);
  describe(reached, images.name, options, result.report);
  FittedOrgan organ{.function = ImplicitFunction(options.kernel, solver.merged().set.points, solution,
                                                 options.solve_tolerance_pixels * pixel_mm),
                    .poses = {},
                    .seeds_mm = leading_points(set, pairs)};
  result.report.contour_residual =
      residual_of(distances_to_zero_set_mm(organ.function, all.points.leftCols(all.values.size() / 2)));
  result.report.smoothing = options.smoothing;
  result.report.solves = 1;
  result.report.solve_seconds = solve_watch.seconds();

  for (const Slice& slice : images.slices) organ.add_plane(slice.pose);
  const BoundedField bounded = bounded_field(organ, options);
  extract_organ(organ, bounded, options, progress, result);
  retriangulate_organ(bounded, options, progress, result);
  result.surface.name = images.name;
  return result;
}

}  // namespace isostack
