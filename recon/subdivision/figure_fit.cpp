#include "recon/subdivision/figure_fit.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace isostack {

namespace {

constexpr int last_level_of_keys = 1;

PlacedVertices held_at(const FigureInterpolator& figures, const SubdivisionLevels& levels, int level) {
  std::vector<Eigen::Vector2d> places;
  PlacedVertices result;
  for (const SourceLoop& source : figures.sources) {
    const std::size_t count = source.vertices.size();
    const int parts = 1 << level;
    for (std::size_t e = 0; e < count; ++e) {
      const std::vector<int> chain =
          refined_chain({source.vertices[e], source.vertices[(e + 1) % count]}, levels, 0, level);
      for (int j = 0; j < parts; ++j) {
        result.vertices.push_back(chain[static_cast<std::size_t>(j)]);
        places.push_back(source.levels.at(static_cast<Eigen::Index>(e), static_cast<double>(j) / parts));
      }
    }
  }
  if (level <= last_level_of_keys) {
    std::set<int> added;  // a pinch is named twice
    for (const int v : figures.key_vertices) {
      if (!added.insert(v).second) continue;
      result.vertices.push_back(v);
      places.emplace_back(figures.base.vertices.col(v).head<2>());
    }
  }
  result.places_mm.resize(2, static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) result.places_mm.col(static_cast<Eigen::Index>(i)) = places[i];
  return result;
}

/// Where places of the base lie on the sources' own curves.
class SourceCurves {
 public:
  explicit SourceCurves(const FigureInterpolator& figures) : figures_(figures) {
    for (std::size_t s = 0; s < figures.sources.size(); ++s) {
      const auto& vertices = figures.sources[s].vertices;
      for (std::size_t e = 0; e < vertices.size(); ++e)
        edges_[{vertices[e], vertices[(e + 1) % vertices.size()]}] = {s, e};
    }
  }

  Eigen::Vector2d joined(const BasePlace& place) const {
    Eigen::Vector2d result(0, 0);
    std::map<double, std::vector<std::size_t>> at_time;
    for (std::size_t i = 0; i < 4 && place.vertex[i] >= 0; ++i)
      at_time[figures_.base.vertices(2, place.vertex[i])].push_back(i);
    for (const auto& [t, corners] : at_time) {
      double share = 0;
      for (const std::size_t i : corners) share += place.weight[i];
      result += share * on_curve(place, corners, share);
    }
    return result;
  }

 private:
  Eigen::Vector2d on_curve(const BasePlace& place, const std::vector<std::size_t>& corners, double share) const {
    const int a = place.vertex[corners.front()], b = place.vertex[corners.back()];
    const double way = place.weight[corners.back()] / share;
    if (corners.size() == 1) return figures_.base.vertices.col(a).head<2>();
    if (const auto at = edges_.find({a, b}); at != edges_.end()) return on_edge(at->second, way);
    if (const auto at = edges_.find({b, a}); at != edges_.end()) return on_edge(at->second, 1 - way);
    return (1 - way) * figures_.base.vertices.col(a).head<2>() + way * figures_.base.vertices.col(b).head<2>();
  }

  Eigen::Vector2d on_edge(const std::pair<std::size_t, std::size_t>& edge, double way) const {
    return figures_.sources[edge.first].levels.at(static_cast<Eigen::Index>(edge.second), way);
  }

  const FigureInterpolator& figures_;
  std::map<std::pair<int, int>, std::pair<std::size_t, std::size_t>> edges_;
};

/// The base with its vertices moved from the sources to the middle of their details, by the mean deviation from the
/// base's edges on both sides, nearer places counting more.
Eigen::MatrixXd through_details(const FigureInterpolator& figures) {
  Eigen::MatrixXd result = figures.base.vertices;
  for (const SourceLoop& source : figures.sources) {
    const auto count = static_cast<Eigen::Index>(source.vertices.size());
    const int segments = source.levels.segments;
    for (Eigen::Index e = 0; e < count; ++e) {
      const int from = source.vertices[static_cast<std::size_t>(e)];
      const int to = source.vertices[static_cast<std::size_t>((e + 1) % count)];
      for (int j = 1; j < segments; ++j) {
        const double share = static_cast<double>(j) / segments;
        const Eigen::Vector2d straight =
            (1 - share) * figures.base.vertices.col(from).head<2>() + share * figures.base.vertices.col(to).head<2>();
        const Eigen::Vector2d off = (source.levels.at(e, share) - straight) / segments;  // both sides' weights sum to 1
        result.col(from).head<2>() += (1 - share) * off;
        result.col(to).head<2>() += share * off;
      }
    }
  }
  return result;
}

}  // namespace

FitProblem figure_problem(const FigureInterpolator& figures, int levels, bool lingering) {
  FitProblem problem{.levels = subdivision_levels(figures.base.simplices, figures.base.vertex_count(), levels),
                     .base = figures.base.vertices,
                     .held = {}};
  Eigen::MatrixXd straight = through_details(figures).topRows(2);
  for (int k = 0; k <= levels; ++k) {
    problem.held.push_back(held_at(figures, problem.levels, k));
    if (k > 0) straight = midpoint_refined(straight, problem.levels.steps[static_cast<std::size_t>(k) - 1]);
    problem.reference.push_back(straight);
  }
  if (!lingering) return problem;
  const SourceCurves curves(figures);
  const std::vector<BasePlace> places = base_places(problem.levels);
  for (Eigen::MatrixXd& reference : problem.reference) {
    problem.details.emplace_back(2, reference.cols());
    for (Eigen::Index v = 0; v < reference.cols(); ++v)
      problem.details.back().col(v) = curves.joined(places[static_cast<std::size_t>(v)]) - reference.col(v);
    reference += problem.details.back();
  }
  return problem;
}

}  // namespace isostack
