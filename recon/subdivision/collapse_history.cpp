#include "recon/subdivision/collapse_history.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <queue>

#include "recon/geometry/errors.h"
#include "recon/surface/editable_mesh.h"
#include "recon/surface/quadric.h"

namespace isostack {

namespace {

struct Candidate {
  double cost;
  int gone;
  unsigned version;
  bool operator<(const Candidate& other) const {
    return cost != other.cost ? cost > other.cost : gone > other.gone;  // the cheapest comes first
  }
};

class Collapser {
 public:
  explicit Collapser(const TriangleMesh& input)
      : mesh_(input), quadrics_(input.vertices_mm.size()), versions_(input.vertices_mm.size(), 0) {
    for (int v = 0; v < mesh_.vertex_slots(); ++v) {
      if (mesh_.has_vertex(v) && mesh_.is_fixed(v))
        throw GeometryError(input.name.empty() ? "surface" : input.name,
                            "the mesh has a border, or two sheets that touch in a point",
                            "close it, or retriangulate it first");
      vertices_ += mesh_.has_vertex(v) ? 1 : 0;
    }
    for (int t = 0; t < mesh_.triangle_slots(); ++t) add_plane(t);
  }

  CollapseHistory run() {
    for (std::size_t before = history_.splits.size() + 1; before != history_.splits.size() && vertices_ > 4;) {
      before = history_.splits.size();
      for (int v = 0; v < mesh_.vertex_slots(); ++v) offer(v);
      while (!queue_.empty() && vertices_ > 4) {
        const Candidate next = queue_.top();
        queue_.pop();
        if (next.version == versions_[index(next.gone)]) try_removing(next.gone);
      }
    }
    for (int t = 0; t < mesh_.triangle_slots(); ++t) history_.coarse.push_back(mesh_.triangle(t));
    return std::move(history_);
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void add_plane(int t) {
    const Eigen::Vector3d area = mesh_.area_normal(t);
    if (area.norm() == 0) return;
    const Eigen::Vector3d through = mesh_.position(mesh_.triangle(t)[0]);
    for (const int v : mesh_.triangle(t)) quadrics_[index(v)].add_plane(area.normalized(), through, area.norm());
  }

  /// The length keeps triangles round where the surface is flat; crowded vertices and triangles that turn over are
  /// left for last.
  double cost(int keep, int gone) const {
    const Eigen::Vector3d& there = mesh_.position(keep);
    const double length = mesh_.length(keep, gone);
    const auto crowd =
        static_cast<double>(mesh_.triangles_at(keep).size()) + static_cast<double>(mesh_.triangles_at(gone).size()) - 4;
    const double error = std::max(quadrics_[index(gone)].at(there), 0.0) + 1e-3 * std::pow(length, 4);
    return error * (crowd > 8 ? 1 + (crowd - 8) * (crowd - 8) : 1) *
           (mesh_.keeps_directions(gone, there, 0.1, keep) ? 1 : 1000);
  }

  void offer(int v) {
    if (!mesh_.has_vertex(v)) return;
    double best = std::numeric_limits<double>::max();
    for (const int keep : mesh_.neighbours(v)) best = std::min(best, cost(keep, v));
    queue_.push({best, v, ++versions_[index(v)]});
  }

  void try_removing(int gone) {
    std::vector<std::pair<double, int>> ways;
    for (const int keep : mesh_.neighbours(gone)) ways.emplace_back(cost(keep, gone), keep);
    std::sort(ways.begin(), ways.end());
    for (const auto& [price, keep] : ways) {
      if (!mesh_.may_collapse(keep, gone)) continue;
      remove(keep, gone);
      return;
    }
  }

  void remove(int keep, int gone) {
    const EditableMesh::Sides edge = mesh_.sides(keep, gone);
    VertexSplit split{keep, gone, {}, edge.triangles, {}};
    for (std::size_t side = 0; side < 2; ++side) split.flattened_were[side] = mesh_.triangle(edge.triangles[side]);
    for (const int t : mesh_.triangles_at(gone))
      if (t != edge.triangles[0] && t != edge.triangles[1]) split.moved.push_back(t);
    history_.splits.push_back(std::move(split));
    quadrics_[index(keep)] = quadrics_[index(keep)] + quadrics_[index(gone)];
    mesh_.collapse(keep, gone, mesh_.position(keep));
    --vertices_;
    ++versions_[index(gone)];
    offer(keep);
    for (const int v : mesh_.neighbours(keep)) offer(v);
  }

  EditableMesh mesh_;
  std::vector<Quadric> quadrics_;
  std::vector<unsigned> versions_;
  std::priority_queue<Candidate> queue_;
  int vertices_ = 0;
  CollapseHistory history_;
};

}  // namespace

CollapseHistory collapsed(const TriangleMesh& mesh) { return Collapser(mesh).run(); }

}  // namespace isostack
