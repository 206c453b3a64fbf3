#include "recon/subdivision/multiresolution_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "recon/geometry/errors.h"
#include "recon/subdivision/level_operators.h"
#include "recon/subdivision/local_bending.h"

namespace isostack {

namespace {

/// Surfaces with more vertices are iterated, since fill grows faster than they do; as the levels before have done most
/// of the work, less exactly.
constexpr Eigen::Index most_factored = 40'000;
constexpr double surface_tolerance = 1e-2;

/// The share ρ of level k's weight in that of the levels 0 to k (eqs. A.2 to A.4).
double own_share(double gamma, int k) {
  double sum = 0;
  for (int i = 0; i <= k; ++i) sum += std::pow(gamma, i - k);
  return 1 / sum;
}

void require_constraints(const FitProblem& problem) {
  for (const FitConstraint& constraint : problem.constraints) {
    if (constraint.level < 0 || constraint.level > problem.levels.finest())
      throw InputError("constraint", fmt::format("level {} of {}", constraint.level, problem.levels.finest()),
                       "name a level from 0 to the finest");
    const auto count = problem.levels.vertex_count(constraint.level);
    for (const int v : constraint.vertices)
      if (v < 0 || v >= count)
        throw InputError("constraint", fmt::format("vertex {}, but level {} has {}", v, constraint.level, count),
                         "name vertices that the level has");
  }
}

/// All that is fixed at a level; sources win over constraints.
PlacedVertices targets(const FitProblem& problem, int level, const Eigen::RowVectorXd& t_mm) {
  const PlacedVertices& held = problem.held[static_cast<std::size_t>(level)];
  std::set<int> taken(held.vertices.begin(), held.vertices.end());
  PlacedVertices result = held;
  std::vector<Eigen::VectorXd> more;
  for (const FitConstraint& constraint : problem.constraints) {
    if (constraint.level > level) continue;
    for (const int v : refined_chain(constraint.vertices, problem.levels, constraint.level, level)) {
      if (!taken.insert(v).second) continue;
      result.vertices.push_back(v);
      more.push_back(constraint.place_mm(t_mm[v]));
    }
  }
  result.places_mm.conservativeResize(problem.base.rows() - 1, static_cast<Eigen::Index>(result.vertices.size()));
  for (std::size_t i = 0; i < more.size(); ++i)
    result.places_mm.col(static_cast<Eigen::Index>(held.vertices.size() + i)) = more[i];
  return result;
}

double residual(const PlacedVertices& targets, const Eigen::MatrixXd& surface) {
  double largest = 0;
  for (std::size_t i = 0; i < targets.vertices.size(); ++i)
    largest = std::max(largest,
                       (targets.places_mm.col(static_cast<Eigen::Index>(i)) - surface.col(targets.vertices[i])).norm());
  return largest;
}

/// Taubin's filter: what is smooth stays to the second order in its frequency.
Eigen::MatrixXd filtered(const LevelOperators& operators, Eigen::MatrixXd x, int passes,
                         const std::vector<char>& sharp) {
  for (int i = 0; i < passes; ++i) {
    Eigen::MatrixXd change = operators.filter_step(x);
    for (Eigen::Index v = 0; v < x.cols() && !sharp.empty(); ++v)
      if (sharp[static_cast<std::size_t>(v)]) change.col(v).setZero();
    x -= change;
  }
  return x;
}

/// Of the rows at the t of base vertices between the ends: there the surface would have a kink along t.
Eigen::MatrixXd kinks(const LevelOperators& operators, const Eigen::MatrixXd& surface, const Eigen::RowVectorXd& t_mm,
                      const Eigen::RowVectorXd& base_t_mm) {
  const std::set<double> times(base_t_mm.begin(), base_t_mm.end());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(surface.rows(), surface.cols());
  if (times.size() < 3) return result;
  result = operators.stiffness_along_t(surface);
  for (Eigen::Index v = 0; v < surface.cols(); ++v)
    if (!times.contains(t_mm[v]) || t_mm[v] == *times.begin() || t_mm[v] == *times.rbegin()) result.col(v).setZero();
  return result;
}

double mean_edge_mm(const Eigen::MatrixXd& base, const SubdivisionLevels& levels) {
  double sum = 0;
  const auto edges = subdivide(levels.base, base.cols()).edges;
  for (const auto& [a, b] : edges) sum += (base.col(a) - base.col(b)).norm();
  return sum / static_cast<double>(edges.size());
}

struct Level {
  int k = 0;
  SimplicialMesh straight;  ///< halved edges, unsmoothed
  Eigen::MatrixXd surface;  ///< the former level's, refined; then this one's
};

FitLevelReport fit_level(const FitProblem& problem, const FitOptions& options, double edge_mm, Level& level) {
  const Eigen::Index n = level.straight.dimension() - 1;
  const Eigen::RowVectorXd t_mm = level.straight.vertices.row(n);
  const LevelOperators operators(level.straight);
  const PlacedVertices fixed = targets(problem, level.k, t_mm);
  FitLevelReport report{.vertices = t_mm.size(), .first_residual_mm = residual(fixed, level.surface)};
  for (std::size_t i = 0; i < problem.held[static_cast<std::size_t>(level.k)].vertices.size(); ++i)
    level.surface.col(fixed.vertices[i]) = fixed.places_mm.col(static_cast<Eigen::Index>(i));
  Eigen::MatrixXd plain = level.surface;
  if (!problem.details.empty()) plain -= problem.details[static_cast<std::size_t>(level.k)];
  level.surface +=
      own_share(options.gamma, level.k) * (filtered(operators, plain, options.smoothing_passes, problem.sharp) - plain);

  BendingProblem bending{.operators = operators,
                         .counted = (t_mm.array() > t_mm.minCoeff() && t_mm.array() < t_mm.maxCoeff()).cast<double>(),
                         .load = kinks(operators, level.surface, t_mm, problem.base.row(n)),
                         .eta = std::pow(options.reach_edges * edge_mm, -4),
                         .fixed = std::vector<char>(static_cast<std::size_t>(t_mm.size()), 0)};
  Eigen::MatrixXd start = Eigen::MatrixXd::Zero(n, t_mm.size());
  for (std::size_t i = 0; i < fixed.vertices.size(); ++i) {
    const int v = fixed.vertices[i];
    bending.fixed[static_cast<std::size_t>(v)] = 1;
    start.col(v) = fixed.places_mm.col(static_cast<Eigen::Index>(i)) - level.surface.col(v);
  }
  const double tolerance = n == 2 ? std::max(options.tolerance, surface_tolerance) : options.tolerance;
  const BendingSolution solution = n == 2 && t_mm.size() <= most_factored
                                       ? least_bending_factored(bending, std::move(start))
                                       : least_bending(bending, std::move(start), tolerance, options.most_iterations);
  level.surface += solution.displacement;
  for (std::size_t i = 0; i < fixed.vertices.size(); ++i)  // free of rounding
    level.surface.col(fixed.vertices[i]) = fixed.places_mm.col(static_cast<Eigen::Index>(i));
  report.first_energy = solution.first_energy;
  report.energy = solution.energy;
  report.residual_mm = residual(fixed, level.surface);
  report.iterations = solution.iterations;
  report.converged = solution.converged;
  return report;
}

}  // namespace

FittedMesh fit_multiresolution(const FitProblem& problem, const FitOptions& options, const Progress& progress) {
  require_constraints(problem);
  const Eigen::Index n = problem.base.rows() - 1;
  const int finest = problem.levels.finest();
  double edge_mm = mean_edge_mm(problem.base, problem.levels);
  const auto reference = [&](const Level& level) -> Eigen::MatrixXd {
    return problem.reference.empty() ? level.straight.vertices.topRows(n)
                                     : problem.reference[static_cast<std::size_t>(level.k)];
  };
  Level level{.k = 0, .straight = {.vertices = problem.base, .simplices = problem.levels.base}, .surface = {}};
  level.surface = reference(level);
  FittedMesh result;
  while (true) {
    progress.report("optimise", static_cast<double>(level.k) / (finest + 1));
    result.levels.push_back(fit_level(problem, options, edge_mm, level));
    if (level.k == finest) break;
    const SimplexSubdivision& step = problem.levels.steps[static_cast<std::size_t>(level.k)];
    const Eigen::MatrixXd change = midpoint_refined(level.surface - reference(level), step);
    level.straight = {.vertices = midpoint_refined(level.straight.vertices, step), .simplices = step.simplices};
    ++level.k;
    level.surface = reference(level) + change;
    edge_mm /= 2;
  }
  result.mesh = std::move(level.straight);
  result.mesh.vertices.topRows(n) = level.surface;
  return result;
}

}  // namespace isostack
