#include "recon/surface/projection.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

#include "recon/metrics/closest_point.h"
#include "recon/surface/root_finding.h"

namespace isostack {

namespace {

/// A search away from one point, to where the field's sign changes.
struct Search {
  std::size_t number;
  Eigen::Vector3d direction;  ///< out of the surface from inside it, into it from outside
  double value;
};

Eigen::Matrix3Xd as_columns(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = points[i];
  return columns;
}

/// One step of every search. Those whose sign changed leave, as segments with their numbers.
void step(const ScalarField& field, const std::vector<NearSurface>& points, double step_mm,
          std::vector<Search>& searches, std::vector<CrossedSegment>& segments, std::vector<std::size_t>& numbers) {
  std::vector<Eigen::Vector3d> ends;
  for (const Search& search : searches) ends.emplace_back(points[search.number].point_mm + step_mm * search.direction);
  const Eigen::VectorXd values = field.values(as_columns(ends));
  std::vector<Search> rest;
  for (std::size_t i = 0; i < searches.size(); ++i) {
    const double end_value = values[static_cast<Eigen::Index>(i)];
    if ((end_value >= 0) == (searches[i].value >= 0)) {
      rest.push_back(searches[i]);
      continue;
    }
    segments.push_back({points[searches[i].number].point_mm, ends[i], searches[i].value, end_value});
    numbers.push_back(searches[i].number);
  }
  searches = std::move(rest);
}

}  // namespace

Projection onto_mesh(const TriangleMesh& mesh, double reach_mm) {
  return [closest = ClosestPoint(mesh), reach_mm](const std::vector<NearSurface>& points) {
    std::vector<std::optional<Eigen::Vector3d>> placed(points.size());
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
      const auto found = closest.on_side_facing(points[i].outwards, points[i].point_mm);
      if (found && (*found - points[i].point_mm).norm() <= reach_mm) placed[i] = found;
    });
    return placed;
  };
}

Projection onto_zero_set(const ScalarField& field, double reach_mm) {
  return [&field, reach_mm](const std::vector<NearSurface>& points) {
    std::vector<std::optional<Eigen::Vector3d>> placed(points.size());
    std::vector<Eigen::Vector3d> starts;
    for (const NearSurface& point : points) starts.push_back(point.point_mm);
    if (starts.empty()) return placed;
    const Eigen::VectorXd values = field.values(as_columns(starts));
    std::vector<Search> searches;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double value = values[static_cast<Eigen::Index>(i)];
      searches.push_back({i, value >= 0 ? points[i].outwards : Eigen::Vector3d(-points[i].outwards), value});
    }
    // Most points are much nearer than the reach; short segments have fast roots and one sheet in them.
    std::vector<CrossedSegment> segments;
    std::vector<std::size_t> numbers;
    for (const double share : {1.0 / 64, 1.0 / 16, 1.0 / 4, 1.0})
      if (!searches.empty()) step(field, points, share * reach_mm, searches, segments, numbers);
    const std::vector<Eigen::Vector3d> roots = roots_on_segments(field, segments, 1e-4);
    for (std::size_t i = 0; i < roots.size(); ++i) placed[numbers[i]] = roots[i];
    return placed;
  };
}

}  // namespace isostack
