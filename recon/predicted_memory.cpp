#include "recon/predicted_memory.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "recon/constraints/contour_constraints.h"
#include "recon/constraints/contour_samples.h"
#include "recon/constraints/image_constraints.h"
#include "recon/organ_surface.h"
#include "recon/solve_steps.h"
#include "recon/solvers/interpolation_solver.h"
#include "recon/solvers/memory_limit.h"
#include "recon/solvers/product_memory.h"
#include "recon/surface_estimate.h"

namespace isostack {

namespace {

// By measurement (docs/benchmarks.md), with some room.
constexpr double surface_bytes_per_cell = 600;  ///< lattice, roots and mesh
constexpr double mesh_bytes_per_cell = 110;
constexpr std::size_t points_bytes = 25'000'000;  ///< lattice points and contour points with their values

std::size_t bytes(double count) { return static_cast<std::size_t>(count); }

/// A dense system's triangle, touched from the diagonal down, and the blocks of its factorisation.
double dense_bytes(double constraints) { return sizeof(double) * constraints * (0.55 * constraints + 1300); }

/// Evaluating f: one field of a high order and the one tried before it, and far fields kept from place to place.
double field_bytes(const Eigen::MatrixXd& points, const Kernel& kernel) {
  constexpr Eigen::Index least_for_fast_sums = 3000, many = 12'000;
  if (points.cols() < least_for_fast_sums) return 0;
  // The more centres, the nearer the order comes to its limit: r³ leaves the largest errors.
  const int order = kernel.power < 3 ? 8 : points.cols() < many ? 10 : 12;
  const FarFieldOptions far{.order = order, .order_growth = 1, .most_order = 14};
  const OctreeDomain domain = OctreeDomain::fitted(points, 2, 90);
  const double field = static_cast<double>(product_memory(Octree(points, domain, 90), far).sources);
  return 1.3 * field + 20e6 + 400.0 * static_cast<double>(points.cols());
}

double pixel_mm_of(const ContourStack& contours) {
  double pixel_mm = std::numeric_limits<double>::infinity();
  for (const ContourSlice& slice : contours.slices) pixel_mm = std::min(pixel_mm, slice.pose.spacing_mm.minCoeff());
  return pixel_mm;
}

/// By how much planes and sections that stray add to the constraints: the farther apart the points kept, the more.
double growth(const ContourStack& contours, std::size_t kept, double pixel_mm) {
  double length_mm = 0;
  for (const ContourSlice& slice : contours.slices)
    for (const Contour& contour : slice.contours) length_mm += perimeter_mm(contour);
  const double spacing_pixels = length_mm / static_cast<double>(std::max<std::size_t>(kept, 1)) / pixel_mm;
  return 1.05 + std::clamp(0.28 * (spacing_pixels - 1), 0.0, 0.7);
}

/// Surface cells at a resolution: a plane passes 1.5 cells per h² on average over all directions.
double cells_at(double area_mm2, double resolution_mm) { return 1.6 * area_mm2 / (resolution_mm * resolution_mm); }

void predict_surface(double area_mm2, double diagonal_mm, double pixel_mm, const ReconstructOptions& options,
                     OrganPrediction& organ) {
  organ.resolution_mm = options.resolution_mm > 0 ? options.resolution_mm : std::max(pixel_mm, diagonal_mm / 600);
  // Cells are halved where the surface would miss a contour, or is too coarse for it.
  const double finest_mm = options.resolution_mm > 0 ? options.resolution_mm : 0.5 * organ.resolution_mm;
  organ.cells = bytes(cells_at(area_mm2, organ.resolution_mm));
  organ.surface_bytes = bytes(surface_bytes_per_cell * cells_at(area_mm2, finest_mm));
  organ.kept_bytes = bytes(mesh_bytes_per_cell * cells_at(area_mm2, finest_mm));
}

/// So many more points, between those that follow each other along contours.
Eigen::MatrixXd grown(const Eigen::MatrixXd& points, double growth) {
  const Eigen::Index count = points.cols();
  const auto extra = static_cast<Eigen::Index>((growth - 1) * static_cast<double>(count));
  Eigen::MatrixXd all(points.rows(), count + extra);
  all.leftCols(count) = points;
  for (Eigen::Index k = 0; k < extra; ++k) {
    const Eigen::Index i = k * (count - 1) / std::max<Eigen::Index>(extra, 1);
    all.col(count + k) = (points.col(i) + points.col(i + 1)) / 2;
  }
  return all;
}

void predict_solve(const Eigen::MatrixXd& points, double growth, const InterpolationOptions& options,
                   OrganPrediction& organ) {
  const Eigen::MatrixXd all = grown(points, growth);
  organ.constraints = static_cast<std::size_t>(points.cols());
  organ.most_constraints = static_cast<std::size_t>(all.cols());
  organ.solver = InterpolationSolver::uses_fast(options.solver, organ.constraints) ? "fast" : "dense";
  organ.solver_bytes = InterpolationSolver::required_bytes(points, options);
  require_memory(organ.constraints, organ.solver_bytes, options.memory_limit_bytes);
  const bool ends_fast = InterpolationSolver::uses_fast(options.solver, organ.most_constraints);
  double solve = ends_fast ? static_cast<double>(InterpolationSolver::required_bytes(all, options)) : 0;
  if (organ.solver == "dense")  // what makes it fast comes in one step, after planes have added little
    solve = std::max(
        solve, dense_bytes(ends_fast ? 1.05 * static_cast<double>(points.cols()) : static_cast<double>(all.cols())));
  const double field = field_bytes(all, options.kernel);
  organ.solve_bytes = bytes(solve + field) + points_bytes + organ.kept_bytes;
  organ.surface_bytes += bytes(field) + points_bytes;
  organ.kept_bytes += bytes(field);
}

OrganPrediction predict(const ContourStack& contours, const ReconstructOptions& options) {
  require_two_slices(contours);
  OrganPrediction organ;
  organ.name = contours.name;
  organ.contour_points = point_count(contours);
  const double pixel_mm = pixel_mm_of(contours);
  const std::vector<ContourSample> samples = sample_contours(
      contours, {.max_samples = options.max_constraints / 3, .min_spacing_pixels = options.sample_spacing_pixels});
  organ.boundary_constraints = samples.size();
  const ConstraintSet set = signed_constraints(contours, samples, {.offset_pixels = options.offset_pixels}).constraints;
  Eigen::AlignedBox3d box;
  for (const ContourSlice& slice : contours.slices) {
    organ.contours += slice.contours.size();
    for (const Contour& contour : slice.contours)
      for (const Eigen::Vector2d& point : contour.points_mm) box.extend(slice.pose.slice_to_world(point));
  }
  const double wider_mm = 0.5 * box.diagonal().norm();  // a quarter on either side, as StackBounds
  predict_surface(estimated_area_mm2(contours), (box.sizes().array() + wider_mm).matrix().norm(), pixel_mm, options,
                  organ);
  predict_solve(set.points, growth(contours, samples.size(), pixel_mm), interpolation_options(options, pixel_mm),
                organ);
  return organ;
}

MemoryPrediction together(std::vector<OrganPrediction> organs, std::size_t held_bytes, bool keeps_functions) {
  std::size_t held = held_bytes, most = held_bytes;
  for (const OrganPrediction& organ : organs) {
    most = std::max(most, held + std::max(organ.solve_bytes, organ.surface_bytes));
    if (keeps_functions) held += organ.kept_bytes;
  }
  for (const OrganPrediction& organ : organs)  // once more where organs overlap
    if (keeps_functions) most = std::max(most, held + organ.surface_bytes);
  return {.organs = std::move(organs), .process_bytes = most};
}

}  // namespace

MemoryPrediction predict_memory(const std::vector<ContourStack>& stacks, const ReconstructOptions& options,
                                std::size_t held_bytes) {
  std::vector<OrganPrediction> organs;
  for (const ContourStack& stack : stacks) organs.push_back(predict(stack, options));
  return together(std::move(organs), held_bytes, stacks.size() > 1 && !options.allow_overlap);
}

MemoryPrediction predict_memory_turk_obrien(const SliceStack& images, double level, const ReconstructOptions& options,
                                            std::size_t held_bytes) {
  const ConstraintSet set = image_constraint_set(images, level, options.max_constraints);
  const Eigen::Index pairs = set.values.size() / 2;
  require_two_slices(pairs > 0 ? images.slices.size() : 0, images.slices.size(), images.name);
  OrganPrediction organ;
  organ.name = images.name;
  organ.boundary_constraints = static_cast<std::size_t>(pairs);
  const ConstraintSet all = image_constraint_set(images, level, std::numeric_limits<std::size_t>::max());
  organ.contour_points = static_cast<std::size_t>(all.values.size() / 2);
  const double pixel_mm = images.slices.front().pose.spacing_mm.minCoeff();
  const Eigen::Vector3d sizes = all.points.rowwise().maxCoeff() - all.points.rowwise().minCoeff();
  const Eigen::VectorXd places = images.slices.front().pose.normal().transpose() * all.points;
  const double gap_mm = (places.maxCoeff() - places.minCoeff()) / static_cast<double>(images.slices.size());
  // Every boundary point stands for about a pixel of a band as wide as the slices are apart, or more where it slants.
  const double area_mm2 = 1.3 * static_cast<double>(organ.contour_points) * pixel_mm * std::max(gap_mm, pixel_mm);
  ReconstructOptions once = options;  // this surface is not refined
  if (once.resolution_mm <= 0) once.resolution_mm = std::max(pixel_mm, 2 * sizes.norm() / 600);
  predict_surface(area_mm2, 2 * sizes.norm(), pixel_mm, once, organ);
  predict_solve(set.points, 1, interpolation_options(options, pixel_mm), organ);
  return together({std::move(organ)}, held_bytes, false);
}

}  // namespace isostack
