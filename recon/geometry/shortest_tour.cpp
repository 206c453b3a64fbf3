#include "recon/geometry/shortest_tour.h"

#include <algorithm>
#include <cmath>

namespace isostack {

namespace {

using Tour = std::vector<Eigen::Vector2d>;

/// Gains below this, mm, are rounding.
constexpr double least_gain = 1e-9;
/// Ends the search on input that would keep it busy; every round improves the tour.
constexpr int most_rounds = 200;

const Eigen::Vector2d& after(const Tour& tour, std::size_t i) { return tour[i + 1 < tour.size() ? i + 1 : 0]; }

double length(const Tour& tour) {
  double sum = 0;
  for (std::size_t i = 0; i < tour.size(); ++i) sum += (after(tour, i) - tour[i]).norm();
  return sum;
}

Tour nearest_first(Tour tour) {
  for (std::size_t i = 0; i + 2 < tour.size(); ++i) {
    const auto next = tour.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    std::iter_swap(next, std::min_element(next, tour.end(), [&](const auto& a, const auto& b) {
                     return (a - tour[i]).squaredNorm() < (b - tour[i]).squaredNorm();
                   }));
  }
  return tour;
}

Tour by_angle(Tour tour) {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : tour) centre += point / static_cast<double>(tour.size());
  const auto angle = [&](const Eigen::Vector2d& p) { return std::atan2(p.y() - centre.y(), p.x() - centre.x()); };
  std::stable_sort(tour.begin(), tour.end(), [&](const auto& a, const auto& b) { return angle(a) < angle(b); });
  return tour;
}

/// Replaces two edges by two shorter ones wherever that is possible: no two edges cross afterwards.
bool turn_stretches(Tour& tour) {
  bool improved = false;
  for (std::size_t i = 0; i + 2 < tour.size(); ++i)
    for (std::size_t j = i + 2; j < tour.size(); ++j) {
      if (i == 0 && j + 1 == tour.size()) continue;
      const Eigen::Vector2d &a = tour[i], &b = tour[i + 1], &c = tour[j], &d = after(tour, j);
      const double gain = (b - a).norm() + (d - c).norm() - (c - a).norm() - (d - b).norm();
      if (gain < least_gain) continue;
      std::reverse(tour.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   tour.begin() + static_cast<std::ptrdiff_t>(j) + 1);
      improved = true;
    }
  return improved;
}

/// Moves the stretch of `count` points that starts behind the first to where it makes the tour shortest.
bool move_stretch(Tour& tour, std::size_t count) {
  const Eigen::Vector2d first = tour[1], last = tour[count], before = tour[0], behind = tour[count + 1];
  const double saved = (first - before).norm() + (behind - last).norm() - (behind - before).norm();
  double best = least_gain;
  std::size_t place = 0;
  bool is_turned = false;
  for (std::size_t i = count + 1; i < tour.size(); ++i) {
    const Eigen::Vector2d &a = tour[i], &b = after(tour, i);
    const double forward = saved + (b - a).norm() - (first - a).norm() - (b - last).norm();
    const double backward = saved + (b - a).norm() - (last - a).norm() - (b - first).norm();
    if (std::max(forward, backward) <= best) continue;
    best = std::max(forward, backward);
    place = i;
    is_turned = backward > forward;
  }
  if (place == 0) return false;
  const auto begin = tour.begin() + 1, end = begin + static_cast<std::ptrdiff_t>(count);
  if (is_turned) std::reverse(begin, end);
  std::rotate(begin, end, tour.begin() + static_cast<std::ptrdiff_t>(place) + 1);
  return true;
}

bool move_stretches(Tour& tour) {
  bool improved = false;
  for (std::size_t i = 0; i < tour.size(); ++i) {
    for (std::size_t count = 1; count <= 3 && count + 3 <= tour.size(); ++count)
      improved = move_stretch(tour, count) || improved;
    std::rotate(tour.begin(), tour.begin() + 1, tour.end());
  }
  return improved;
}

Tour improved(Tour tour) {
  for (int round = 0; round < most_rounds; ++round) {
    const bool turned = turn_stretches(tour);
    if (!move_stretches(tour) && !turned) break;
  }
  while (turn_stretches(tour)) {  // the last word, so that nothing crosses
  }
  return tour;
}

}  // namespace

Tour shortest_tour(Tour points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  if (points.size() < 4) return points;
  Tour greedy = improved(nearest_first(points)), angular = improved(by_angle(points));
  return length(angular) < length(greedy) ? angular : greedy;
}

}  // namespace isostack
