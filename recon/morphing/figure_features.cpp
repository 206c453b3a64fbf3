#include "recon/morphing/figure_features.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/geometry/errors.h"
#include "recon/geometry/self_crossing.h"
#include "recon/subdivision/directed_loops.h"

namespace isostack {

namespace {

constexpr double nearest_share = 0.05;  // of a figure's size: farther away no point can be meant

double diagonal_mm(const NamedFigure& figure) {
  Eigen::AlignedBox2d box;
  for (const Contour& contour : figure.contours)
    for (const Eigen::Vector2d& point : contour.points_mm) box.extend(point);
  return box.diagonal().norm();
}

const NamedFigure& figure_of(const std::vector<NamedFigure>& figures, const FeaturePoint& feature) {
  if (feature.shape >= figures.size())
    throw InputError("feature", fmt::format("shape {} of {}", feature.shape, figures.size()),
                     "name shapes by their numbers, from 0");
  return figures[feature.shape];
}

Eigen::Vector2d vertex_place(const NamedFigure& figure, std::size_t vertex) {
  std::size_t rest = vertex;
  for (const Contour& contour : figure.contours) {
    if (rest < contour.points_mm.size()) return contour.points_mm[rest];
    rest -= contour.points_mm.size();
  }
  throw InputError(figure.name, fmt::format("a feature names vertex {}, but it has {}", vertex, vertex - rest),
                   "name vertices by their numbers, from 0, or by their places");
}

/// Makes the place a point of the nearest contour.
Eigen::Vector2d inserted(NamedFigure& figure, const Eigen::Vector2d& place) {
  double least = std::numeric_limits<double>::infinity();
  std::size_t contour = 0, edge = 0;
  double share = 0;
  for (std::size_t c = 0; c < figure.contours.size(); ++c) {
    const auto& points = figure.contours[c].points_mm;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d side = points[(i + 1) % points.size()] - points[i];
      const double s = side.squaredNorm() > 0 ? (place - points[i]).dot(side) / side.squaredNorm() : 0;
      const double at = std::clamp(s, 0.0, 1.0), distance = (place - points[i] - at * side).norm();
      if (!(distance < least)) continue;
      least = distance;
      contour = c;
      edge = i;
      share = at;
    }
  }
  if (!(least <= nearest_share * diagonal_mm(figure)))
    throw InputError(figure.name,
                     fmt::format("no contour is near the feature at ({:.4g}, {:.4g}); the nearest is {:.4g} mm away",
                                 place.x(), place.y(), least),
                     "name a place on a contour, in slice mm");
  auto& points = figure.contours[contour].points_mm;
  Eigen::Vector2d from = points[edge], to = points[(edge + 1) % points.size()];
  constexpr double at_end = 0.05;  // no sliver beside a vertex
  if (share < at_end) return from;
  if (share > 1 - at_end) return to;
  Eigen::Vector2d point = from + share * (to - from);
  points.insert(points.begin() + static_cast<std::ptrdiff_t>(edge) + 1, point);
  return point;
}

SourcePoint found(const std::vector<NamedFigure>& figures, std::size_t shape, const Eigen::Vector2d& place) {
  const std::vector<Contour>& contours = figures[shape].contours;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const auto at = std::find(contours[c].points_mm.begin(), contours[c].points_mm.end(), place);
    if (at != contours[c].points_mm.end())
      return {.layer = static_cast<int>(shape),
              .contour = static_cast<int>(c),
              .point = static_cast<int>(at - contours[c].points_mm.begin())};
  }
  return {};
}

}  // namespace

void require_no_crossing(const NamedFigure& figure) {
  const auto refuse = [&](const Eigen::Vector2d& place) {
    throw InputError(figure.name, fmt::format("its contours cross at ({:.4g}, {:.4g}) mm", place.x(), place.y()),
                     "trace it again, or let another method take it");
  };
  for (std::size_t i = 0; i < figure.contours.size(); ++i) {
    if (const auto place = self_crossing(figure.contours[i])) refuse(*place);
    for (std::size_t j = 0; j < i; ++j)
      if (cross_each_other(figure.contours[i], figure.contours[j])) refuse(figure.contours[i].points_mm.front());
  }
}

std::vector<std::array<SourcePoint, 2>> features_in(std::vector<NamedFigure>& figures,
                                                    const std::vector<CorrespondingPoints>& features) {
  std::vector<std::array<Eigen::Vector2d, 2>> places(features.size());
  for (std::size_t f = 0; f < features.size(); ++f) {  // numbers are those before anything is inserted
    const FeaturePoint &from = features[f].from, &to = features[f].to;
    figure_of(figures, from);
    figure_of(figures, to);
    if (from.shape + 1 != to.shape && to.shape + 1 != from.shape)
      throw InputError("feature", fmt::format("shapes {} and {} do not follow each other", from.shape, to.shape),
                       "join points of neighbouring shapes, one pair after the other");
    std::size_t end = 0;
    for (const FeaturePoint* point : {&from, &to}) {
      if (point->vertex)
        places[f][end] = vertex_place(figures[point->shape], *point->vertex);
      else if (point->place_mm.size() != 2)
        throw InputError("feature", fmt::format("a place with {} coordinates", point->place_mm.size()),
                         "give two for figures");
      ++end;
    }
  }
  for (std::size_t f = 0; f < features.size(); ++f) {
    if (!features[f].from.vertex) places[f][0] = inserted(figures[features[f].from.shape], features[f].from.place_mm);
    if (!features[f].to.vertex) places[f][1] = inserted(figures[features[f].to.shape], features[f].to.place_mm);
  }
  std::vector<std::array<SourcePoint, 2>> result;
  for (std::size_t f = 0; f < features.size(); ++f)
    result.push_back(
        {found(figures, features[f].from.shape, places[f][0]), found(figures, features[f].to.shape, places[f][1])});
  return result;
}

}  // namespace isostack
