#include "recon/subdivision/face_triangulation.h"

#include <Eigen/LU>
#include <algorithm>

namespace isostack {

FaceTriangulation::FaceTriangulation(const std::array<Eigen::Vector2d, 3>& corners)
    : points_(corners.begin(), corners.end()), side_of_(3, -1), triangles_{{0, 1, 2}} {}

double FaceTriangulation::area(int a, int b, int c) const {
  const auto p = [&](int i) -> const Eigen::Vector2d& { return points_[static_cast<std::size_t>(i)]; };
  const Eigen::Vector2d u = p(b) - p(a), v = p(c) - p(a);
  return u.x() * v.y() - u.y() * v.x();
}

FaceTriangulation::Pair FaceTriangulation::pair_at(int a, int b) const {
  Pair found;
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (int c = 0; c < 3; ++c) {
      const int from = triangles_[t][c], to = triangles_[t][(c + 1) % 3], third = triangles_[t][(c + 2) % 3];
      if (from == a && to == b) {
        found.left = static_cast<int>(t);
        found.left_corner = third;
      } else if (from == b && to == a) {
        found.right = static_cast<int>(t);
        found.right_corner = third;
      }
    }
  return found;
}

bool FaceTriangulation::has_edge(int a, int b) const {
  const Pair pair = pair_at(a, b);
  return pair.left >= 0 || pair.right >= 0;
}

int FaceTriangulation::add_inside(const Eigen::Vector2d& point) {
  const int added = static_cast<int>(points_.size());
  points_.push_back(point);
  side_of_.push_back(-1);
  const auto least = [&](const Eigen::Vector3i& t) {
    return std::min({area(t[0], t[1], added), area(t[1], t[2], added), area(t[2], t[0], added)}) /
           area(t[0], t[1], t[2]);
  };
  const auto holds = std::max_element(triangles_.begin(), triangles_.end(),
                                      [&](const auto& s, const auto& t) { return least(s) < least(t); });
  const Eigen::Vector3i t = *holds;
  if (least(t) < 1e-7) {
    const auto p = [&](int c) { return points_[static_cast<std::size_t>(t[c])]; };
    Eigen::Vector3d shares(area(t[1], t[2], added), area(t[2], t[0], added), area(t[0], t[1], added));
    shares = (shares / area(t[0], t[1], t[2])).cwiseMax(1e-6);
    shares /= shares.sum();
    points_.back() = shares[0] * p(0) + shares[1] * p(1) + shares[2] * p(2);
  }
  *holds = {t[0], t[1], added};
  triangles_.emplace_back(t[1], t[2], added);
  triangles_.emplace_back(t[2], t[0], added);
  return added;
}

int FaceTriangulation::add_on_side(int side, const Eigen::Vector2d& point) {
  const int added = static_cast<int>(points_.size());
  const int first = side, last = (side + 1) % 3;
  const auto along = [&](const Eigen::Vector2d& p) {
    const Eigen::Vector2d way = points_[static_cast<std::size_t>(last)] - points_[static_cast<std::size_t>(first)];
    return (p - points_[static_cast<std::size_t>(first)]).dot(way);
  };
  int before = first, after = last;
  for (int i = 3; i < added; ++i) {
    if (side_of_[static_cast<std::size_t>(i)] != side) continue;
    const double here = along(points_[static_cast<std::size_t>(i)]);
    const auto place = [&](int j) { return along(points_[static_cast<std::size_t>(j)]); };
    if (here <= along(point) && here >= place(before)) before = i;
    if (here > along(point) && here <= place(after)) after = i;
  }
  points_.push_back(point);
  side_of_.push_back(side);
  const Pair pair = pair_at(before, after);
  Eigen::Vector3i& t = triangles_[static_cast<std::size_t>(pair.left)];
  t = {before, added, pair.left_corner};
  triangles_.emplace_back(added, after, pair.left_corner);
  return added;
}

/// Turns an inner edge within its two triangles; not where these are no convex quadrilateral.
bool FaceTriangulation::flip(int a, int b) {
  const Pair pair = pair_at(a, b);
  if (pair.left < 0 || pair.right < 0) return false;
  const int c = pair.left_corner, d = pair.right_corner;
  const double whole = area(a, b, c) + area(b, a, d);
  if (std::min(area(a, d, c), area(d, b, c)) < 1e-9 * whole) return false;
  triangles_[static_cast<std::size_t>(pair.left)] = {a, d, c};
  triangles_[static_cast<std::size_t>(pair.right)] = {d, b, c};
  return true;
}

void FaceTriangulation::make_delaunay() {
  const auto wants_flip = [&](int a, int b) {
    if (std::find(kept_.begin(), kept_.end(), Edge(std::minmax(a, b))) != kept_.end()) return false;
    const Pair pair = pair_at(a, b);
    if (pair.left < 0 || pair.right < 0) return false;
    const auto cotangent = [&](int at, int p, int q) {
      const Eigen::Vector2d u = points_[static_cast<std::size_t>(p)] - points_[static_cast<std::size_t>(at)];
      const Eigen::Vector2d v = points_[static_cast<std::size_t>(q)] - points_[static_cast<std::size_t>(at)];
      return u.dot(v) / area(at, p, q);
    };
    return cotangent(pair.left_corner, a, b) + cotangent(pair.right_corner, b, a) < -1e-9;
  };
  // Each flip makes the smallest angles larger; the limit is for numbers that disagree about that.
  for (std::size_t round = 0; round < 4 * triangles_.size(); ++round) {
    bool flipped = false;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (int c = 0; c < 3; ++c) {
        const int a = triangles_[t][c], b = triangles_[t][(c + 1) % 3];
        if (a < b && wants_flip(a, b)) flipped |= flip(a, b);
      }
    if (!flipped) return;
  }
}

void FaceTriangulation::join(int a, int b) {
  for (std::size_t attempt = 0; attempt < 8 * triangles_.size() && !has_edge(a, b); ++attempt) {
    bool flipped = false;
    for (std::size_t t = 0; t < triangles_.size() && !flipped; ++t)
      for (int c = 0; c < 3 && !flipped; ++c) {
        const int p = triangles_[t][c], q = triangles_[t][(c + 1) % 3];
        if (p > q || p == a || p == b || q == a || q == b) continue;
        const bool crosses = area(a, b, p) * area(a, b, q) < 0 && area(p, q, a) * area(p, q, b) < 0;
        const bool is_kept = std::find(kept_.begin(), kept_.end(), Edge(p, q)) != kept_.end();
        // Every second time one that crosses after the flip, too, so that it does not go to and fro.
        if (crosses && !is_kept && (t + attempt) % 2 == 0) flipped = flip(p, q);
      }
  }
  if (has_edge(a, b)) kept_.emplace_back(std::minmax(a, b));
}

}  // namespace isostack
