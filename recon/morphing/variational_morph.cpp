#include "recon/morphing/variational_morph.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "recon/geometry/errors.h"
#include "recon/geometry/stopwatch.h"
#include "recon/morphing/solved_morph.h"

namespace isostack {

namespace {

constexpr int most_dimensions = 6;  // the kernels' sums know no more

bool are_figures(const std::vector<KeyShape>& shapes) { return dimension_of(shapes.front().shape) == 2; }

void require_options(const VariationalMorphOptions& options, const KeyPlaces& places, int shape_dimension) {
  if (options.spacing_mm && !(*options.spacing_mm > 0 && std::isfinite(*options.spacing_mm)))
    throw InputError("spacing", fmt::format("{} mm is not a distance", *options.spacing_mm), "give more than 0");
  const auto dimensions = shape_dimension + static_cast<int>(places.coordinates.rows());
  if (dimensions > most_dimensions)
    throw InputError(
        "morph", fmt::format("{} shapes at corners make {} dimensions", places.key_count(), dimensions),
        fmt::format("give {} shapes at most, or put them on a line", most_dimensions - shape_dimension + 1));
}

std::vector<ShapeConstraints> constraints_of(const std::vector<KeyShape>& shapes,
                                             const VariationalMorphOptions& options) {
  const SlicePose pose = common_pose(shapes);
  const std::size_t share = options.max_constraints / shapes.size();
  std::vector<ShapeConstraints> constraints;
  for (const KeyShape& shape : shapes) {
    constraints.push_back(are_figures(shapes) ? figure_constraints(shape, pose, options, share)
                                              : body_constraints(shape, options, share));
    if (constraints.back().boundary_count == 0)
      throw InputError(shape.name, "it has no boundary to constrain", "check the level, or give a larger shape");
  }
  return constraints;
}

/// Every shape's constraints at its place in the extra dimensions: [x; place].
ConstraintSet at_places(const std::vector<ShapeConstraints>& shapes, const Eigen::MatrixXd& places_mm,
                        double smoothing) {
  const Eigen::Index n = shapes.front().set.points.rows(), m = places_mm.rows();
  Eigen::Index total = 0, at = 0;
  for (const ShapeConstraints& shape : shapes) total += shape.set.values.size();
  ConstraintSet all{Eigen::MatrixXd(n + m, total), Eigen::VectorXd(total), {}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const ConstraintSet& set = shapes[i].set;
    all.points.block(0, at, n, set.values.size()) = set.points;
    all.points.block(n, at, m, set.values.size()).colwise() = places_mm.col(static_cast<Eigen::Index>(i));
    all.values.segment(at, set.values.size()) = set.values;
    at += set.values.size();
  }
  if (smoothing > 0) all.smoothing = Eigen::VectorXd::Constant(total, smoothing);
  return all;
}

/// A thousandth of a pixel or of a body's box, as a value of the function.
double value_tolerance(const VariationalMorphOptions& options, double fine_mm) {
  const double share = options.solve_tolerance_pixels;
  return options.recipe == MorphRecipe::turk_obrien ? share : share * fine_mm;
}

void solve(SolvedMorph& morph, const VariationalMorphOptions& options, double fine_mm, MorphReport& report,
           const Progress& progress) {
  const ConstraintSet all =
      at_places(morph.constraints, morph.spacing_mm * morph.places.coordinates, options.smoothing);
  morph.tolerance_mm = value_tolerance(options, fine_mm);
  InterpolationSolver solver(all,
                             {.kernel = options.kernel,
                              .solver = options.solver,
                              .tolerance = morph.tolerance_mm,
                              .merge_distance = 0.01 * fine_mm,
                              .memory_limit_bytes = options.memory_limit_bytes},
                             progress);
  morph.solution = solver.solve(all.values, {}, report.solve, progress);
  morph.centres = solver.merged().set.points;
  report.constraints = static_cast<std::size_t>(morph.centres.cols());
  if (!report.solve.converged)
    throw SolveError("morph",
                     fmt::format("the solve stalled at a residual of {:.2g}: {}", report.solve.largest_residual,
                                 report.solve.remark),
                     "add smoothing, or use fewer constraints");
}

}  // namespace

Morph variational_morph(const std::vector<KeyShape>& shapes, const VariationalMorphOptions& options,
                        const Progress& progress) {
  require_morphable(shapes);
  SolvedMorph morph{.shapes = shapes,
                    .constraints = {},
                    .places = key_places(shapes, options.layout),
                    .kernel = options.kernel,
                    .centres = {},
                    .solution = {}};
  require_options(options, morph.places, dimension_of(shapes.front().shape));
  MorphReport report;
  report.method = "variational";
  const double side_mm = box_of(shapes).sizes().maxCoeff();
  const double fine_mm = are_figures(shapes) ? common_pose(shapes).spacing_mm.minCoeff() : 1e-2 * side_mm;
  report.spacing_mm = morph.spacing_mm = options.spacing_mm.value_or(side_mm / (are_figures(shapes) ? 2 : 4));
  report.resolution_mm = morph.resolution_mm = options.resolution_mm > 0 ? options.resolution_mm : fine_mm;

  const Stopwatch constraint_watch;
  progress.report("constraints", 0);
  morph.constraints = constraints_of(shapes, options);
  report.constraint_seconds = constraint_watch.seconds();
  const Stopwatch solve_watch;
  solve(morph, options, fine_mm, report, progress);
  report.solve_seconds = solve_watch.seconds();

  const KeyPlaces places = morph.places;
  return Morph(are_figures(shapes) ? figure_sections(std::move(morph)) : body_sections(std::move(morph)), places,
               std::move(report));
}

}  // namespace isostack
