#include "recon/morphing/body_features.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr double nearest_share = 0.05;  // of a body's size: farther away no vertex can be meant

const TriangleMesh& body_of(const std::vector<TriangleMesh>& bodies, const FeaturePoint& feature) {
  if (feature.shape >= bodies.size())
    throw InputError("feature", fmt::format("shape {} of {}", feature.shape, bodies.size()),
                     "name shapes by their numbers, from 0");
  return bodies[feature.shape];
}

int vertex_of(const TriangleMesh& body, const FeaturePoint& feature) {
  if (feature.vertex) {
    if (*feature.vertex >= body.vertices_mm.size())
      throw InputError(
          body.name, fmt::format("a feature names vertex {}, but it has {}", *feature.vertex, body.vertices_mm.size()),
          "name vertices by their numbers, from 0, or by their places");
    return static_cast<int>(*feature.vertex);
  }
  if (feature.place_mm.size() != 3 || !feature.place_mm.allFinite())
    throw InputError(body.name, "a feature has no place of three coordinates", "give x, y and z in mm, or a vertex");
  const Eigen::Vector3d place = feature.place_mm;
  Eigen::AlignedBox3d box;
  int nearest = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t v = 0; v < body.vertices_mm.size(); ++v) {
    box.extend(body.vertices_mm[v]);
    const double distance = (body.vertices_mm[v] - place).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = static_cast<int>(v);
  }
  if (least > nearest_share * box.diagonal().norm())
    throw InputError(body.name, fmt::format("a feature is {:.3g} mm away from its nearest vertex", least),
                     "give a place on the surface");
  return nearest;
}

}  // namespace

BodyFeatures features_in(const std::vector<TriangleMesh>& bodies, const std::vector<CorrespondingPoints>& features) {
  BodyFeatures made;
  made.pairs.resize(bodies.size() - 1);
  std::vector<std::vector<std::size_t>> which(bodies.size() - 1);
  for (std::size_t f = 0; f < features.size(); ++f) {
    const bool forwards = features[f].from.shape < features[f].to.shape;
    const FeaturePoint& first = forwards ? features[f].from : features[f].to;
    const FeaturePoint& second = forwards ? features[f].to : features[f].from;
    const VertexPair pair{vertex_of(body_of(bodies, first), first), vertex_of(body_of(bodies, second), second)};
    if (second.shape != first.shape + 1)
      throw InputError("feature", fmt::format("shapes {} and {} do not follow each other", first.shape, second.shape),
                       "name points of neighbouring shapes");
    for (const VertexPair& other : made.pairs[first.shape])
      if (other.from == pair.from || other.to == pair.to)
        throw InputError("feature", "two features have the same point", "give each point one counterpart");
    made.pairs[first.shape].push_back(pair);
    which[first.shape].push_back(f);
  }
  for (const auto& step : which) made.order.insert(made.order.end(), step.begin(), step.end());
  return made;
}

std::vector<int> sharp_corners(const TriangleMesh& body, double sharp_angle_rad, std::size_t most) {
  const auto normal = [&](std::size_t t) {
    const auto p = [&](int c) { return body.vertices_mm[static_cast<std::size_t>(body.triangles[t][c])]; };
    return Eigen::Vector3d((p(1) - p(0)).cross(p(2) - p(0)));
  };
  std::map<std::pair<int, int>, std::size_t> left_of;
  for (std::size_t t = 0; t < body.triangles.size(); ++t)
    for (int c = 0; c < 3; ++c) left_of[{body.triangles[t][c], body.triangles[t][(c + 1) % 3]}] = t;
  std::map<int, std::pair<int, double>> edges_at;  // vertex: sharp edges, sum of their angles
  for (const auto& [edge, left] : left_of) {
    const auto right = left_of.find({edge.second, edge.first});
    if (edge.first > edge.second || right == left_of.end()) continue;
    const Eigen::Vector3d a = normal(left), b = normal(right->second);
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    if (angle <= sharp_angle_rad) continue;
    for (const int v : {edge.first, edge.second}) {
      ++edges_at[v].first;
      edges_at[v].second += angle;
    }
  }
  std::vector<std::pair<double, int>> corners;
  for (const auto& [v, sharp] : edges_at)
    if (sharp.first >= 3) corners.emplace_back(-sharp.second, v);
  std::stable_sort(corners.begin(), corners.end());
  if (corners.size() > most) corners.resize(most);
  std::vector<int> made;
  for (const auto& [turn, v] : corners) made.push_back(v);
  return made;
}

}  // namespace isostack
