#include "recon/subdivision/figure_strips.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>

#include "recon/geometry/errors.h"
#include "recon/subdivision/loop_tiling.h"
#include "recon/subdivision/pinched_loops.h"

namespace isostack {

namespace {

struct Size {
  Eigen::Vector2d centre_mm = {0, 0};
  double area_mm2 = 0;
};

Size size_of(const std::vector<Eigen::Vector2d>& loop) {
  Size size;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d &a = loop[i], &b = loop[(i + 1) % loop.size()];
    const double twice = a.x() * b.y() - a.y() * b.x();
    size.centre_mm += twice / 6 * (a + b);
    size.area_mm2 += twice / 2;
  }
  if (size.area_mm2 != 0) size.centre_mm /= size.area_mm2;
  return size;
}

/// Of the vertex in a ring that may pass it twice: all its places there.
std::vector<int> places_in(const VertexRing& ring, int vertex) {
  std::vector<int> result;
  for (std::size_t i = 0; i < ring.vertices.size(); ++i)
    if (ring.vertices[i] == vertex) result.push_back(static_cast<int>(i));
  return result;
}

}  // namespace

/// Rings that become one another: one on one side at least, or all on one side.
struct FigureStrips::Group {
  std::vector<VertexRing> lower, upper;
};

int FigureStrips::add_vertex(const Eigen::Vector2d& place_mm, double t_mm) {
  vertices_.emplace_back(place_mm.x(), place_mm.y(), t_mm);
  return static_cast<int>(vertices_.size()) - 1;
}

std::vector<Eigen::Vector2d> FigureStrips::places(const VertexRing& ring) const {
  std::vector<Eigen::Vector2d> result;
  for (const int v : ring.vertices) result.push_back(place(v));
  return result;
}

double FigureStrips::unlikeness(const VertexRing& a, const VertexRing& b) const {
  const Size one = size_of(places(a)), other = size_of(places(b));
  const double radius_mm = std::sqrt(std::sqrt(std::abs(one.area_mm2 * other.area_mm2)) / std::numbers::pi);
  return (one.centre_mm - other.centre_mm).norm() +
         0.5 * radius_mm * std::abs(std::log(std::abs(one.area_mm2 / other.area_mm2)));
}

double FigureStrips::gap_mm(const VertexRing& a, const VertexRing& b) const {
  double least = std::numeric_limits<double>::infinity();
  for (const int v : a.vertices)
    for (const int w : b.vertices) least = std::min(least, (place(v) - place(w)).norm());
  return least;
}

std::vector<FigureStrips::Group> FigureStrips::groups(const std::vector<VertexRing>& lower,
                                                      const std::vector<VertexRing>& upper,
                                                      const std::vector<JoinedVertices>& joined) const {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < lower.size(); ++i)
    for (std::size_t j = 0; j < upper.size(); ++j) {
      const bool must = std::any_of(joined.begin(), joined.end(), [&](const JoinedVertices& pair) {
        return !places_in(lower[i], pair.lower).empty() && !places_in(upper[j], pair.upper).empty();
      });
      if (must && lower[i].is_hole != upper[j].is_hole)
        throw InputError("features", "an outer contour and a hole are to become one another",
                         "name features of contours of the same kind");
      if (lower[i].is_hole == upper[j].is_hole) pairs.emplace_back(must ? -1 : unlikeness(lower[i], upper[j]), i, j);
    }
  std::sort(pairs.begin(), pairs.end());
  std::vector<Group> result;
  std::vector<std::optional<std::size_t>> of_lower(lower.size()), of_upper(upper.size());
  for (const auto& [cost, i, j] : pairs) {
    if (of_lower[i] || of_upper[j]) continue;
    of_lower[i] = of_upper[j] = result.size();
    result.push_back({.lower = {lower[i]}, .upper = {upper[j]}});
  }
  const auto take_in = [&](const std::vector<VertexRing>& rings, const std::vector<std::optional<std::size_t>>& taken,
                           auto Group::*side) {
    for (std::size_t i = 0; i < rings.size(); ++i) {
      if (taken[i]) continue;
      double least = std::numeric_limits<double>::infinity();
      std::optional<std::size_t> nearest;
      for (std::size_t k = 0; k < rings.size(); ++k) {
        if (!taken[k] || rings[k].is_hole != rings[i].is_hole) continue;
        if (const double gap = gap_mm(rings[i], rings[k]); gap < least)
          std::tie(least, nearest) = std::tuple(gap, taken[k]);
      }
      if (!nearest) {
        result.emplace_back();
        nearest = result.size() - 1;
      }
      (result[*nearest].*side).push_back(rings[i]);
    }
  };
  take_in(lower, of_lower, &Group::lower);
  take_in(upper, of_upper, &Group::upper);
  return result;
}

void FigureStrips::tile(const VertexRing& lower, const VertexRing& upper, const std::vector<JoinedVertices>& joined) {
  TilingRules rules;
  for (const JoinedVertices& pair : joined) {
    const std::vector<int> i = places_in(lower, pair.lower), j = places_in(upper, pair.upper);
    if (!i.empty() && !j.empty()) rules.joined.emplace_back(i.front(), j.front());
  }
  std::vector<LoopPair> edges;
  for (bool again = true; again;) {  // a pinch, passed twice, must not have the same edge twice
    edges = tile_loops(places(lower), places(upper), rules);
    std::set<std::pair<int, int>> seen;
    again = false;
    for (const auto& [i, j] : edges) {
      const std::pair ends(lower.vertices[static_cast<std::size_t>(i)], upper.vertices[static_cast<std::size_t>(j)]);
      if (!seen.insert(ends).second) again = rules.not_joined.insert({i, j}).second || again;
    }
  }
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto& [i, j] = edges[e];
    const auto& [next_i, next_j] = edges[(e + 1) % edges.size()];
    const int a = lower.vertices[static_cast<std::size_t>(i)], b = upper.vertices[static_cast<std::size_t>(j)];
    if (next_i != i)
      triangles_.emplace_back(a, lower.vertices[static_cast<std::size_t>(next_i)], b);
    else
      triangles_.emplace_back(a, upper.vertices[static_cast<std::size_t>(next_j)], b);
  }
}

void FigureStrips::cap(const VertexRing& ring, double t_mm, bool dies) {
  const int apex = add_vertex(size_of(places(ring)).centre_mm, t_mm);
  for (std::size_t i = 0; i < ring.vertices.size(); ++i) {
    const int here = ring.vertices[i], next = ring.vertices[(i + 1) % ring.vertices.size()];
    triangles_.emplace_back(dies ? here : next, dies ? next : here, apex);
  }
}

void FigureStrips::tie(const Group& group, const std::vector<JoinedVertices>& joined) {
  const bool splits = group.upper.size() > group.lower.size();
  const std::vector<VertexRing>& many = splits ? group.upper : group.lower;
  const VertexRing& one = (splits ? group.lower : group.upper).front();
  const double t_mm = (time(many.front()) + time(one)) / 2;
  std::vector<std::vector<Eigen::Vector2d>> loops;
  std::vector<int> of_many;
  for (const VertexRing& ring : many) {
    loops.push_back(places(ring));
    of_many.insert(of_many.end(), ring.vertices.begin(), ring.vertices.end());
  }
  const PinchedLoops tied = tied_together(loops);
  std::vector<int> vertex_of(tied.next.size(), -1);
  for (std::size_t p = 0; p < vertex_of.size(); ++p) {
    for (const auto& [a, b] : tied.pinches)
      if (b == static_cast<int>(p) && vertex_of[static_cast<std::size_t>(a)] >= 0)
        vertex_of[p] = vertex_of[static_cast<std::size_t>(a)];
      else if (a == static_cast<int>(p) && vertex_of[static_cast<std::size_t>(b)] >= 0)
        vertex_of[p] = vertex_of[static_cast<std::size_t>(b)];
    if (vertex_of[p] < 0) vertex_of[p] = add_vertex(tied.places_mm[p], t_mm);
  }
  std::vector<JoinedVertices> to_many, to_one;
  for (const JoinedVertices& pair : joined) {
    const int far = splits ? pair.upper : pair.lower, near = splits ? pair.lower : pair.upper;
    const auto at = std::find(of_many.begin(), of_many.end(), far);
    if (at == of_many.end() || places_in(one, near).empty()) continue;
    const int middle = vertex_of[static_cast<std::size_t>(at - of_many.begin())];
    to_many.push_back(splits ? JoinedVertices{middle, far} : JoinedVertices{far, middle});
    to_one.push_back(splits ? JoinedVertices{near, middle} : JoinedVertices{middle, near});
  }
  const auto ring_of = [&](const std::vector<int>& passes) {
    VertexRing ring{.vertices = {}, .is_hole = one.is_hole};
    for (const int pass : passes) ring.vertices.push_back(vertex_of[static_cast<std::size_t>(pass)]);
    return ring;
  };
  const auto separate = tied.loops(std::vector<bool>(tied.pinches.size(), false));
  for (std::size_t i = 0; i < separate.size(); ++i) {
    const VertexRing middle = ring_of(separate[i]);
    if (splits)
      tile(middle, many[i], to_many);
    else
      tile(many[i], middle, to_many);
  }
  const VertexRing whole = ring_of(tied.loops(std::vector<bool>(tied.pinches.size(), true)).front());
  if (splits)
    tile(one, whole, to_one);
  else
    tile(whole, one, to_one);
}

void FigureStrips::join(const std::vector<VertexRing>& lower, const std::vector<VertexRing>& upper,
                        const std::vector<JoinedVertices>& joined) {
  const double middle_mm = (time(lower.front()) + time(upper.front())) / 2;
  for (const Group& group : groups(lower, upper, joined)) {
    if (group.lower.size() == 1 && group.upper.size() == 1) {
      tile(group.lower.front(), group.upper.front(), joined);
    } else if (group.lower.empty() || group.upper.empty()) {
      for (const VertexRing& ring : group.lower) cap(ring, middle_mm, true);
      for (const VertexRing& ring : group.upper) cap(ring, middle_mm, false);
    } else {
      tie(group, joined);
    }
  }
}

SimplicialMesh FigureStrips::mesh() const {
  SimplicialMesh result;
  result.vertices.resize(3, static_cast<Eigen::Index>(vertices_.size()));
  result.simplices.resize(3, static_cast<Eigen::Index>(triangles_.size()));
  for (std::size_t v = 0; v < vertices_.size(); ++v) result.vertices.col(static_cast<Eigen::Index>(v)) = vertices_[v];
  for (std::size_t s = 0; s < triangles_.size(); ++s)
    result.simplices.col(static_cast<Eigen::Index>(s)) = triangles_[s];
  return result;
}

}  // namespace isostack
