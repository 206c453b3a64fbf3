#include "recon/geometry/loop_edges.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace isostack {

namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Where two segments cross, each within itself.
std::optional<Eigen::Vector2d> crossing(const Eigen::Vector2d& a_from, const Eigen::Vector2d& a_to,
                                        const Eigen::Vector2d& b_from, const Eigen::Vector2d& b_to) {
  const Eigen::Vector2d along_a = a_to - a_from, along_b = b_to - b_from;
  const double b_start = cross(along_a, b_from - a_from), b_end = cross(along_a, b_to - a_from);
  const double a_start = cross(along_b, a_from - b_from), a_end = cross(along_b, a_to - b_from);
  if ((b_start > 0) == (b_end > 0) || (a_start > 0) == (a_end > 0)) return std::nullopt;
  return a_from + along_a * (a_start / (a_start - a_end));
}

}  // namespace

LoopEdges::LoopEdges(const std::vector<Contour>& contours, double tolerance_mm) : tolerance_mm_(tolerance_mm) {
  for (std::size_t loop = 0; loop < contours.size(); ++loop) {
    std::vector<int> path;
    for (const Eigen::Vector2d& place : contours[loop].points_mm) {
      const int point = point_at(place);
      if (path.empty() || path.back() != point) path.push_back(point);
    }
    while (path.size() > 1 && path.front() == path.back()) path.pop_back();
    if (path.size() < 2) continue;
    const std::size_t first = edges_.size();
    for (std::size_t i = 0; i < path.size(); ++i)
      edges_.push_back({path[i], path[(i + 1) % path.size()], static_cast<int>(loop), first + (i + 1) % path.size()});
  }
}

int LoopEdges::point_at(const Eigen::Vector2d& place) {
  const long x = std::lround(place.x() / tolerance_mm_), y = std::lround(place.y() / tolerance_mm_);
  for (long i = x - 1; i <= x + 1; ++i)
    for (long j = y - 1; j <= y + 1; ++j) {
      const auto cell = cells_.find({i, j});
      if (cell == cells_.end()) continue;
      for (const int point : cell->second)
        if ((at(point) - place).norm() <= tolerance_mm_) return point;
    }
  points_.push_back(place);
  const int point = static_cast<int>(points_.size()) - 1;
  cells_[{x, y}].push_back(point);
  return point;
}

bool LoopEdges::is_on(int point, const LoopEdge& edge) const {
  if (point == edge.from || point == edge.to) return false;
  const Eigen::Vector2d along = at(edge.to) - at(edge.from), offset = at(point) - at(edge.from);
  const double share = offset.dot(along) / along.squaredNorm();
  return share > 0 && share < 1 && (offset - share * along).norm() <= tolerance_mm_;
}

bool LoopEdges::meet(const LoopEdge& a, const LoopEdge& b) const {
  if (is_on(a.from, b) || is_on(a.to, b) || is_on(b.from, a) || is_on(b.to, a)) return true;
  const bool a_then_b = a.loop == b.loop && &edges_[a.next] == &b, b_then_a = a.loop == b.loop && &edges_[b.next] == &a;
  const bool turns_back = a.from == b.to && a.to == b.from;
  if (a_then_b || b_then_a) return turns_back;
  if (a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to) return true;
  return crossing(at(a.from), at(a.to), at(b.from), at(b.to)).has_value();
}

template <class Visit>
void LoopEdges::for_each_close_pair(Visit visit) const {
  struct Box {
    Eigen::Vector2d low, high;
    std::size_t edge;
  };
  std::vector<Box> boxes;
  boxes.reserve(edges_.size());
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(tolerance_mm_);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Eigen::Vector2d &a = at(edges_[i].from), &b = at(edges_[i].to);
    boxes.push_back({a.cwiseMin(b) - margin, a.cwiseMax(b), i});
  }
  std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.low.x() < b.low.x(); });
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size() && boxes[j].low.x() <= boxes[i].high.x(); ++j)
      if (boxes[j].low.y() <= boxes[i].high.y() && boxes[i].low.y() <= boxes[j].high.y())
        visit(boxes[i].edge, boxes[j].edge);
}

std::vector<std::pair<int, int>> LoopEdges::meetings() const {
  std::vector<std::pair<int, int>> pairs;
  for_each_close_pair([&](std::size_t i, std::size_t j) {
    const LoopEdge &a = edges_[i], &b = edges_[j];
    const bool known = !pairs.empty() && pairs.back() == std::pair(a.loop, b.loop);
    if (!known && meet(a, b)) pairs.emplace_back(a.loop, b.loop);
  });
  return pairs;
}

bool LoopEdges::cut_once() {
  std::vector<std::vector<int>> cuts(edges_.size());
  std::vector<std::tuple<std::size_t, std::size_t, Eigen::Vector2d>> crossings;
  for_each_close_pair([&](std::size_t i, std::size_t j) {
    const LoopEdge &a = edges_[i], &b = edges_[j];
    bool touch = a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
    for (const int point : {b.from, b.to})
      if (is_on(point, a)) cuts[i].push_back(point), touch = true;
    for (const int point : {a.from, a.to})
      if (is_on(point, b)) cuts[j].push_back(point), touch = true;
    if (touch) return;
    if (const auto place = crossing(at(a.from), at(a.to), at(b.from), at(b.to))) crossings.emplace_back(i, j, *place);
  });
  for (const auto& [i, j, place] : crossings) {
    const int point = point_at(place);
    cuts[i].push_back(point);
    cuts[j].push_back(point);
  }
  std::vector<LoopEdge> pieces;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const LoopEdge& edge = edges_[i];
    const Eigen::Vector2d start = at(edge.from);
    std::sort(cuts[i].begin(), cuts[i].end(), [&](int a, int b) {
      return std::pair((at(a) - start).squaredNorm(), a) < std::pair((at(b) - start).squaredNorm(), b);
    });
    int from = edge.from;
    cuts[i].push_back(edge.to);
    for (const int to : cuts[i]) {
      if (to != from) pieces.push_back({from, to, edge.loop, 0});
      from = to;
    }
  }
  const bool changed = pieces.size() != edges_.size();
  edges_ = std::move(pieces);
  return changed;
}

void LoopEdges::cut_where_they_meet() {
  // Cutting bends an edge by up to the tolerance, which may make it meet another one.
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds && cut_once();) ++round;
}

}  // namespace isostack
