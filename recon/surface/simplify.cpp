#include "recon/surface/simplify.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <queue>
#include <tuple>
#include <vector>

#include "recon/metrics/surface_distance.h"
#include "recon/surface/editable_mesh.h"
#include "recon/surface/quadric.h"
#include "recon/surface/tracked_distance.h"

namespace isostack {

namespace {

/// Makes the best place unique and evens out the triangles where the surface is flat.
constexpr double point_weight = 1e-4;
// Triangles may not turn farther than this in one collapse, nor get narrower than this unless they were.
constexpr double turn_cosine = 0.3, least_shape = 0.08;

/// A collapse and the state of both ends it was thought out for.
struct Candidate {
  double cost;
  int keep, gone;
  unsigned keep_state, gone_state;
  Eigen::Vector3d there;
  bool operator<(const Candidate& other) const {  // the queue's top is the largest
    return std::tie(other.cost, other.keep, other.gone) < std::tie(cost, keep, gone);
  }
};

/// 1 for an equilateral triangle, 0 for one without area.
double shape(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return squares > 0 ? 2 * std::sqrt(3.0) * (b - a).cross(c - a).norm() / squares : 0;
}

class Simplifier {
 public:
  Simplifier(const TriangleMesh& input, double limit_mm, std::size_t triangles)
      : mesh_(input), goal_(triangles), quadrics_(input.vertices_mm.size()), states_(input.vertices_mm.size(), 0) {
    for (const Eigen::Vector3d& v : input.vertices_mm) centre_mm_ += v / static_cast<double>(input.vertices_mm.size());
    if (limit_mm > 0) distance_.emplace(input, mesh_, limit_mm);
    for (int t = 0; t < mesh_.triangle_slots(); ++t) add_quadrics(t);
  }

  /// Passes over all edges until one hardly finds anything to collapse: what was refused may be possible later.
  TriangleMesh run(const Progress& progress) {
    std::size_t before = 0;
    do {
      before = mesh_.triangle_count();
      for (int t = 0; t < mesh_.triangle_slots(); ++t)
        if (mesh_.has_triangle(t))
          for (int side = 0; side < 3; ++side) {
            const int a = mesh_.triangle(t)[side], b = mesh_.triangle(t)[(side + 1) % 3];
            if (a < b) consider(a, b);  // border edges never collapse
          }
      collapse_candidates(progress);
    } while (mesh_.triangle_count() > goal_ && 50 * (before - mesh_.triangle_count()) > before);
    return mesh_.compact();
  }

 private:
  static std::size_t at(int v) { return static_cast<std::size_t>(v); }
  Eigen::Vector3d centred(int v) const { return mesh_.position(v) - centre_mm_; }

  void add_quadrics(int t) {
    const Eigen::Vector3d normal = mesh_.area_normal(t);
    const double weight = normal.norm();
    if (!(weight > 0)) return;
    for (const int v : mesh_.triangle(t)) {
      quadrics_[at(v)].add_plane(normal / weight, centred(v), weight);
      quadrics_[at(v)].add_point(centred(v), point_weight * weight);
    }
  }

  void consider(int a, int b) {
    const int keep = mesh_.is_fixed(b) ? b : a, gone = keep == a ? b : a;
    if (mesh_.is_fixed(gone)) return;
    const Quadric sum = quadrics_[at(a)] + quadrics_[at(b)];
    Eigen::Vector3d there = centred(keep);
    if (!mesh_.is_fixed(keep)) {
      const Eigen::Vector3d middle = (centred(a) + centred(b)) / 2, best = sum.a.ldlt().solve(sum.b);
      there = (best - middle).norm() <= 2 * mesh_.length(a, b) ? best : middle;
    }
    candidates_.push({sum.at(there), keep, gone, states_[at(keep)], states_[at(gone)], there + centre_mm_});
  }

  bool is_allowed(const Candidate& candidate) {
    const auto& [cost, keep, gone, keep_state, gone_state, there] = candidate;
    if (!mesh_.may_collapse(keep, gone) || !mesh_.keeps_directions(gone, there, turn_cosine, keep) ||
        (!mesh_.is_fixed(keep) && !mesh_.keeps_directions(keep, there, turn_cosine, gone)))
      return false;
    if (!keeps_shapes(keep, gone, there)) return false;
    return !distance_ || distance_->allows(keep, gone, there);
  }

  /// Whether the narrowest triangle round the edge does not get narrower than allowed.
  bool keeps_shapes(int keep, int gone, const Eigen::Vector3d& there) const {
    double worst_before = least_shape, worst_after = 1;
    for (const int v : {keep, gone})
      for (const int t : mesh_.triangles_at(v)) {
        const Eigen::Vector3i& c = mesh_.triangle(t);
        worst_before = std::min(worst_before, shape(mesh_.position(c[0]), mesh_.position(c[1]), mesh_.position(c[2])));
        const auto is_end = [&](int corner) { return corner == keep || corner == gone; };
        if (is_end(c[0]) + is_end(c[1]) + is_end(c[2]) == 2) continue;  // it goes with the edge
        const auto moved = [&](int corner) { return is_end(corner) ? there : mesh_.position(corner); };
        worst_after = std::min(worst_after, shape(moved(c[0]), moved(c[1]), moved(c[2])));
      }
    return worst_after >= worst_before;
  }

  void collapse_candidates(const Progress& progress) {
    const double first = static_cast<double>(mesh_.triangle_slots());
    for (std::size_t count = 0; !candidates_.empty() && mesh_.triangle_count() > goal_; ++count) {
      if (count % 4096 == 0)
        progress.report("simplify", 1 - static_cast<double>(mesh_.triangle_count() - goal_) / first);
      const Candidate candidate = candidates_.top();
      candidates_.pop();
      const auto& [cost, keep, gone, keep_state, gone_state, there] = candidate;
      if (states_[at(keep)] != keep_state || states_[at(gone)] != gone_state || !is_allowed(candidate)) continue;
      mesh_.collapse(keep, gone, there);
      if (distance_) distance_->commit();
      quadrics_[at(keep)] = quadrics_[at(keep)] + quadrics_[at(gone)];
      ++states_[at(keep)];
      ++states_[at(gone)];
      for (const int other : mesh_.neighbours(keep)) consider(keep, other);
    }
    candidates_ = {};
  }

  EditableMesh mesh_;
  std::size_t goal_;
  Eigen::Vector3d centre_mm_ = Eigen::Vector3d::Zero();  ///< quadrics are about it, for their digits
  std::vector<Quadric> quadrics_;
  std::vector<unsigned> states_;  ///< counts the changes of each vertex
  std::priority_queue<Candidate> candidates_;
  std::optional<TrackedDistance> distance_;
};

}  // namespace

double largest_distance_mm(const TriangleMesh& a, const TriangleMesh& b) {
  const std::size_t samples =
      std::clamp<std::size_t>(2 * std::max(a.triangles.size(), b.triangles.size()), 25'000, 400'000);
  double largest = surface_distance(a, b, {.samples = samples, .seed = 1}).largest_mm;
  for (const double d : distances_to_mesh_mm(a.vertices_mm, b)) largest = std::max(largest, d);
  for (const double d : distances_to_mesh_mm(b.vertices_mm, a)) largest = std::max(largest, d);
  return largest;
}

namespace {

/// The order of quadric errors leaves single places far off: halves the distance while the number can be reached.
TriangleMesh simplify_to_number(const TriangleMesh& mesh, std::size_t triangles, const Progress& progress) {
  TriangleMesh best = Simplifier(mesh, 0, triangles).run(progress);
  const std::size_t reached = best.triangles.size();
  double limit_mm = largest_distance_mm(mesh, best);
  for (int halving = 0; halving < 3 && limit_mm > 0; ++halving) {
    limit_mm /= 2;
    TriangleMesh nearer = Simplifier(mesh, limit_mm, triangles).run(progress);
    if (nearer.triangles.size() > reached) break;
    best = std::move(nearer);
  }
  return best;
}

}  // namespace

TriangleMesh simplify(const TriangleMesh& mesh, const SimplifyOptions& options, const Progress& progress) {
  if (options.tolerance_mm <= 0) return simplify_to_number(mesh, options.triangles, progress);
  double limit_mm = options.tolerance_mm;
  for (int attempt = 0; attempt < 4; ++attempt) {
    TriangleMesh simplified = Simplifier(mesh, limit_mm, options.triangles).run(progress);
    const double reached_mm = largest_distance_mm(mesh, simplified);
    if (reached_mm <= options.tolerance_mm) return simplified;
    limit_mm *= 0.95 * options.tolerance_mm / reached_mm;
  }
  return EditableMesh(mesh).compact();
}

}  // namespace isostack
