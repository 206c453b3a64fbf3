#include "recon/subdivision/contour_levels.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

namespace isostack {

namespace {

constexpr int least_base_edges = 12;  // an edge is at most this part of the whole, so that facets are not too long

/// The contour as a function of a parameter that is i at point i.
class ContourCurve {
 public:
  ContourCurve(const Contour& contour, std::optional<double> sharp_angle_rad) : points_(contour.points_mm) {
    along_.assign(points_.size() + 1, 0);
    for (std::size_t i = 0; i < points_.size(); ++i) along_[i + 1] = along_[i] + (point(i + 1) - point(i)).norm();
    if (sharp_angle_rad) set_tangents(*sharp_angle_rad);
  }

  std::size_t count() const { return points_.size(); }
  double length() const { return along_.back(); }
  const Eigen::Vector2d& point(std::size_t i) const { return points_[i % points_.size()]; }

  /// Length from point 0, in straight lines; the parameter may go round once more.
  double length_to(double u) const {
    const double turn = std::floor(u / static_cast<double>(count()));
    const double rest = u - turn * static_cast<double>(count());
    const auto i = std::min(static_cast<std::size_t>(rest), count() - 1);
    return turn * length() + along_[i] + (rest - static_cast<double>(i)) * (along_[i + 1] - along_[i]);
  }

  Eigen::Vector2d at(double u) const {
    const double rest = std::fmod(u, static_cast<double>(count()));
    const auto i = std::min(static_cast<std::size_t>(rest), count() - 1);
    const double s = rest - static_cast<double>(i);
    if (s == 0) return point(i);
    if (leaving_.empty()) return (1 - s) * point(i) + s * point(i + 1);
    const double chord = along_[i + 1] - along_[i];
    const Eigen::Vector2d from = chord * leaving_[i], to = chord * arriving_[(i + 1) % count()];
    return (1 + 2 * s) * (1 - s) * (1 - s) * point(i) + s * (1 - s) * (1 - s) * from +
           s * s * (3 - 2 * s) * point(i + 1) + s * s * (s - 1) * to;
  }

 private:
  /// Of the cubic pieces: the parabola's through a point and its neighbours, or along the sides at a corner.
  void set_tangents(double sharp_angle_rad) {
    for (std::size_t i = 0; i < count(); ++i) {
      const Eigen::Vector2d before = point(i) - point(i + count() - 1), after = point(i + 1) - point(i);
      const double b = before.norm(), a = after.norm();
      const double turn = std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after));
      const bool is_sharp = std::abs(turn) > sharp_angle_rad || !(a > 0 && b > 0);
      const Eigen::Vector2d tangent =
          is_sharp ? Eigen::Vector2d::Zero().eval() : ((before / b) * a + (after / a) * b).eval() / (a + b);
      arriving_.push_back(is_sharp && b > 0 ? Eigen::Vector2d(before / b) : tangent);
      leaving_.push_back(is_sharp && a > 0 ? Eigen::Vector2d(after / a) : tangent);
    }
  }

  std::vector<Eigen::Vector2d> points_;
  std::vector<double> along_;
  std::vector<Eigen::Vector2d> arriving_, leaving_;
};

double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double length = (b - a).squaredNorm();
  const double share = length > 0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0;
  return (p - a - share * (b - a)).norm();
}

/// The point strictly between two that is farthest from the line between them, after Douglas and Peucker.
std::size_t farthest(const ContourCurve& curve, std::size_t from, std::size_t to, double& distance) {
  std::size_t result = from;
  distance = -1;
  for (std::size_t i = from + 1; i < to; ++i) {
    const double d = distance_to_segment(curve.point(i), curve.point(from), curve.point(to));
    if (d > distance) {
      distance = d;
      result = i;
    }
  }
  return result;
}

/// Points between `from` and `to` that are needed for the tolerance, and so that no edge has more than `most` of them.
void split(const ContourCurve& curve, std::size_t from, std::size_t to, double tolerance, std::size_t most,
           std::set<std::size_t>& chosen) {
  double distance = 0;
  std::size_t at = farthest(curve, from, to, distance);
  if (at == from || (distance <= tolerance && to - from - 1 <= most)) return;
  if (distance <= tolerance) at = (from + to) / 2;
  chosen.insert(at % curve.count());
  split(curve, from, at, tolerance, most, chosen);
  split(curve, at, to, tolerance, most, chosen);
}

std::vector<std::size_t> chosen_points(const ContourCurve& curve, const ContourLevelsOptions& options) {
  std::set<std::size_t> chosen;
  for (const int i : options.kept) chosen.insert(static_cast<std::size_t>(i));
  if (chosen.empty()) chosen.insert(0);
  if (chosen.size() == 1) {
    std::size_t opposite = *chosen.begin();
    for (std::size_t i = 0; i < curve.count(); ++i)
      if ((curve.point(i) - curve.point(*chosen.begin())).norm() >
          (curve.point(opposite) - curve.point(*chosen.begin())).norm())
        opposite = i;
    chosen.insert(opposite);
  }
  const std::vector<std::size_t> corners(chosen.begin(), chosen.end());
  const std::size_t most = (std::size_t{1} << options.levels) - 1;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t to = i + 1 < corners.size() ? corners[i + 1] : corners.front() + curve.count();
    split(curve, corners[i], to, options.tolerance_mm, most, chosen);
  }
  return {chosen.begin(), chosen.end()};
}

/// Long edges get more vertices, evenly; they need not be points of the contour.
std::vector<double> base_parameters(const ContourCurve& curve, const std::vector<std::size_t>& points) {
  std::vector<double> base;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto from = static_cast<double>(points[i]);
    const auto to = static_cast<double>(i + 1 < points.size() ? points[i + 1] : points.front() + curve.count());
    const double length = curve.length_to(to) - curve.length_to(from);
    const int parts = std::max(1, static_cast<int>(std::ceil(least_base_edges * length / curve.length() - 1e-9)));
    base.push_back(from);
    double u = from;
    for (int p = 1; p < parts; ++p) {
      const double wanted = curve.length_to(from) + length * p / parts;
      while (std::floor(u) + 1 < to && curve.length_to(std::floor(u) + 1) <= wanted) u = std::floor(u) + 1;
      const double here = curve.length_to(std::floor(u)), next = curve.length_to(std::floor(u) + 1);
      u = std::floor(u) + (next > here ? (wanted - here) / (next - here) : 0);
      if (u > base.back() && u < to) base.push_back(u);
    }
  }
  return base;
}

/// The contour's points between two base vertices each get the place that is nearest and free; the rest lie evenly
/// between these.
std::vector<double> parameters_of_edge(const ContourCurve& curve, double from, double to, int segments) {
  std::vector<int> points, places;
  for (int i = static_cast<int>(std::floor(from)) + 1; i < to; ++i) points.push_back(i);
  const double start = curve.length_to(from), length = curve.length_to(to) - start;
  for (const int i : points) {
    const double share = length > 0 ? (curve.length_to(i) - start) / length : 0.5;
    const int wanted = static_cast<int>(std::lround(share * segments));
    places.push_back(std::max(wanted, places.empty() ? 1 : places.back() + 1));
  }
  int limit = segments;
  for (std::size_t k = places.size(); k-- > 0;) limit = places[k] = std::min(places[k], limit - 1);
  std::vector<double> result(static_cast<std::size_t>(segments));
  double u = from;
  int place = 0;
  for (std::size_t k = 0; k <= points.size(); ++k) {
    const double next = k < points.size() ? points[k] : to;
    const int next_place = k < points.size() ? places[k] : segments;
    for (int j = place; j < next_place; ++j)
      result[static_cast<std::size_t>(j)] = u + (next - u) * (j - place) / (next_place - place);
    u = next;
    place = next_place;
  }
  return result;
}

}  // namespace

Eigen::Vector2d ContourLevels::at(Eigen::Index edge, double share) const {
  const double along = std::clamp(share, 0.0, 1.0) * segments;
  const auto slot = std::min(static_cast<Eigen::Index>(along), static_cast<Eigen::Index>(segments) - 1);
  const Eigen::Index first = edge * segments + slot, rest = (first + 1) % places_mm.cols();
  const double part = along - static_cast<double>(slot);
  return (1 - part) * places_mm.col(first) + part * places_mm.col(rest);
}

ContourLevels contour_levels(const Contour& contour, const ContourLevelsOptions& options) {
  const ContourCurve curve(contour, options.sharp_angle_rad);
  ContourLevels result{
      .base = base_parameters(curve, chosen_points(curve, options)), .segments = 1 << options.levels, .places_mm = {}};
  result.places_mm.resize(2, result.base_count() * result.segments);
  Eigen::Index next = 0;
  for (std::size_t e = 0; e < result.base.size(); ++e) {
    const double to =
        e + 1 < result.base.size() ? result.base[e + 1] : result.base.front() + static_cast<double>(curve.count());
    for (const double u : parameters_of_edge(curve, result.base[e], to, result.segments))
      result.places_mm.col(next++) = curve.at(u);
  }
  return result;
}

}  // namespace isostack
