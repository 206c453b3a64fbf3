#include "recon/subdivision/fit_guides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>

#include "recon/geometry/errors.h"
#include "recon/subdivision/cardinal_spline.h"
#include "recon/subdivision/rising_chain.h"

namespace isostack {

namespace {

bool are_joined(const FitProblem& problem, int a, int b) {
  const auto has = [&](Eigen::Index s, int v) { return (problem.levels.base.col(s).array() == v).any(); };
  for (Eigen::Index s = 0; s < problem.levels.base.cols(); ++s)
    if (has(s, a) && has(s, b)) return true;
  return false;
}

/// At the coarsest level that has one.
FitConstraint chain_between(const FitProblem& problem, const std::array<int, 2>& ends) {
  FitConstraint made{.level = 0, .vertices = {ends[0], ends[1]}, .place_mm = {}};
  if (are_joined(problem, ends[0], ends[1])) return made;
  SimplicialMesh mesh{.vertices = problem.base, .simplices = problem.levels.base};
  while (true) {
    if (const auto chain = rising_chain(mesh, ends[0], ends[1])) {
      made.vertices = *chain;
      return made;
    }
    if (made.level == problem.levels.finest())
      throw InputError("feature", "its points are too far from each other on the interpolator",
                       "name points that face each other, or raise the number of levels");
    const SimplexSubdivision& step = problem.levels.steps[static_cast<std::size_t>(made.level++)];
    mesh = {.vertices = midpoint_refined(mesh.vertices, step), .simplices = step.simplices};
  }
}

}  // namespace

void add_line(FitProblem& problem, const FeatureLine& line) {
  FitConstraint made = chain_between(problem, line.ends);
  const Eigen::Index n = problem.base.rows() - 1, count = line.by_way_of.cols() + 2;
  Eigen::MatrixXd way(n + 1, count);
  way.leftCols(1) = problem.base.col(line.ends[0]);
  way.rightCols(1) = problem.base.col(line.ends[1]);
  if (count > 2) way.middleCols(1, count - 2) = line.by_way_of;
  std::vector<Eigen::Index> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return way(n, a) < way(n, b); });
  Eigen::RowVectorXd times(count);
  Eigen::MatrixXd places(n, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    times[i] = way(n, order[static_cast<std::size_t>(i)]);
    places.col(i) = way.col(order[static_cast<std::size_t>(i)]).head(n);
    if (i > 0 && !(times[i] > times[i - 1]))
      throw InputError("feature", "two places on its way are at one time", "give each place a time of its own");
  }
  const double first = std::min(way(n, 0), way(n, count - 1)), last = std::max(way(n, 0), way(n, count - 1));
  if (times.minCoeff() < first || times.maxCoeff() > last)
    throw InputError("feature", "a place on its way is not at a time between its ends",
                     "give times between those of the two shapes");
  made.place_mm = [times, places](double t_mm) { return cardinal_spline(times, places, t_mm); };
  if (line.sharp) {
    const int finest = problem.levels.finest();
    problem.sharp.resize(static_cast<std::size_t>(problem.levels.vertex_count(finest)), 0);
    for (const int v : refined_chain(made.vertices, problem.levels, made.level, finest))
      problem.sharp[static_cast<std::size_t>(v)] = 1;
  }
  problem.constraints.push_back(std::move(made));
}

void add_pull(FitProblem& problem, int level, const Eigen::VectorXd& at, const Eigen::VectorXd& to_mm) {
  Eigen::MatrixXd places = problem.base;
  for (int k = 0; k < level; ++k) places = midpoint_refined(places, problem.levels.steps[static_cast<std::size_t>(k)]);
  const auto& held = problem.held[static_cast<std::size_t>(level)].vertices;
  const std::set<int> sources(held.begin(), held.end());
  const Eigen::Index n = problem.base.rows() - 1;
  const Eigen::RowVectorXd t_mm = problem.base.row(n);
  const double same_time_mm = 1e-6 * (t_mm.maxCoeff() - t_mm.minCoeff());
  std::tuple<double, double> least(std::numeric_limits<double>::max(), 0);
  int nearest = -1;
  for (Eigen::Index v = 0; v < places.cols(); ++v) {
    const Eigen::VectorXd way = places.col(v) - at;
    const std::tuple distance(std::floor(std::abs(way[n]) / same_time_mm), way.head(n).norm());
    if (distance >= least || sources.contains(static_cast<int>(v))) continue;
    least = distance;
    nearest = static_cast<int>(v);
  }
  if (nearest < 0) throw InputError("transition", "the level has no vertices between the shapes", "name a finer level");
  problem.constraints.push_back({.level = level, .vertices = {nearest}, .place_mm = [to_mm](double) { return to_mm; }});
}

}  // namespace isostack
