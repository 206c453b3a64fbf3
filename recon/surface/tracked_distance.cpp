#include "recon/surface/tracked_distance.h"

#include <limits>

namespace isostack {

TrackedDistance::TrackedDistance(const TriangleMesh& input, const EditableMesh& mesh, double limit_mm)
    : mesh_(mesh),
      limit_mm_(limit_mm),
      input_(input),
      points_mm_(input.vertices_mm),
      points_of_(input.triangles.size()) {
  std::vector<bool> is_assigned(points_mm_.size(), false);
  for (std::size_t t = 0; t < input.triangles.size(); ++t) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int v : input.triangles[t]) {
      sum += input.vertices_mm[static_cast<std::size_t>(v)];
      if (is_assigned[static_cast<std::size_t>(v)]) continue;
      points_of_[t].push_back(v);
      is_assigned[static_cast<std::size_t>(v)] = true;
    }
    points_of_[t].push_back(static_cast<int>(points_mm_.size()));
    points_mm_.emplace_back(sum / 3);
  }
}

/// The new vertex, the centres of its triangles and the middles of its edges.
bool TrackedDistance::is_near_input(const Eigen::Vector3d& there) const {
  if (!input_.is_within(limit_mm_, there)) return false;
  for (const NewTriangle& t : changed_) {
    const auto& [a, b, c] = t.corners;
    if (!input_.is_within(limit_mm_, (a + b + c) / 3)) return false;
    const Eigen::Vector3d& next = a == there ? b : b == there ? c : a;
    if (!input_.is_within(limit_mm_, (there + next) / 2)) return false;
  }
  return true;
}

bool TrackedDistance::assign_points(int keep, int gone) {
  const auto assign = [&](int point) {
    const Eigen::Vector3d& p = points_mm_[static_cast<std::size_t>(point)];
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    for (std::size_t n = 0; n < changed_.size(); ++n) {
      const double squared = (closest_point_on_triangle(changed_[n].corners, p) - p).squaredNorm();
      if (squared < nearest) nearest = squared, best = n;
    }
    if (nearest > limit_mm_ * limit_mm_) return false;
    assigned_[best].push_back(point);
    return true;
  };
  for (const int v : {keep, gone})
    for (const int t : mesh_.triangles_at(v)) {
      if (v == gone && (t == removed_[0] || t == removed_[1])) continue;  // seen at the other end
      for (const int point : points_of_[static_cast<std::size_t>(t)])
        if (!assign(point)) return false;
    }
  return true;
}

bool TrackedDistance::allows(int keep, int gone, const Eigen::Vector3d& there) {
  removed_ = mesh_.sides(keep, gone).triangles;
  changed_.clear();
  for (const int v : {keep, gone})
    for (const int t : mesh_.triangles_at(v)) {
      if (t == removed_[0] || t == removed_[1]) continue;
      NewTriangle changed{t, {}};
      for (std::size_t i = 0; i < 3; ++i) {
        const int corner = mesh_.triangle(t)[static_cast<Eigen::Index>(i)];
        changed.corners[i] = corner == v ? there : mesh_.position(corner);
      }
      changed_.push_back(changed);
    }
  assigned_.assign(changed_.size(), {});
  return is_near_input(there) && assign_points(keep, gone);  // the quick one first
}

void TrackedDistance::commit() {
  for (const int t : removed_) points_of_[static_cast<std::size_t>(t)].clear();
  for (std::size_t n = 0; n < changed_.size(); ++n)
    points_of_[static_cast<std::size_t>(changed_[n].number)] = std::move(assigned_[n]);
}

}  // namespace isostack
