#include "recon/solve_steps.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/geometry/errors.h"

namespace isostack {

InterpolationOptions interpolation_options(const ReconstructOptions& options, double pixel_mm) {
  return {.kernel = options.kernel,
          .solver = options.solver,
          .tolerance = options.solve_tolerance_pixels * pixel_mm,
          .merge_distance = 0.01 * pixel_mm,  // no contour knows its place better than that
          .memory_limit_bytes = options.memory_limit_bytes};
}

/// The constraints with the same smoothing for each.
ConstraintSet with_smoothing(ConstraintSet set, double smoothing) {
  if (smoothing > 0) set.smoothing = Eigen::VectorXd::Constant(set.values.size(), smoothing);
  return set;
}

void describe(const InterpolationSolver& solver, std::size_t given, ReconstructReport& report) {
  report.constraints = static_cast<std::size_t>(solver.merged().set.values.size());
  report.merged_constraints = given - report.constraints;
  report.largest_contradiction = solver.merged().largest_contradiction;
  report.predicted_bytes = std::max(report.predicted_bytes, solver.predicted_bytes());
}

namespace {

void add_stages(const std::vector<SolveStage>& stages, std::vector<SolveStage>& total) {
  for (const SolveStage& stage : stages) {
    const auto same = std::find_if(total.begin(), total.end(), [&](const auto& s) { return s.name == stage.name; });
    if (same == total.end()) {
      total.push_back(stage);
    } else {
      same->seconds += stage.seconds;
      same->bytes = std::max(same->bytes, stage.bytes);
    }
  }
}

}  // namespace

void describe(const SolveReport& solve, const std::string& name, const ReconstructOptions& options,
              ReconstructReport& report) {
  report.solver = solve.solver;
  report.iterations += solve.iterations;
  report.sweeps += solve.sweeps;
  report.tolerance = solve.tolerance;
  report.largest_residual = solve.largest_residual;
  report.converged = solve.converged;
  report.residual_remark = solve.remark;
  add_stages(solve.stages, report.solve_stages);
  if (!solve.converged && !options.accept_residual)
    throw SolveError(
        name.empty() ? "solve" : name,
        fmt::format("the solve stalled at a residual of {:.2g} mm: {}", solve.largest_residual, solve.remark),
        "accept it with --accept-residual, add --smoothing, or use fewer constraints");
}

}  // namespace isostack
