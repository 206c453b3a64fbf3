#include "recon/subdivision/source_vertices.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <optional>

#include "recon/subdivision/face_triangulation.h"
#include "recon/subdivision/surface_overlay.h"

namespace isostack {

namespace {

std::size_t index(Eigen::Index i) { return static_cast<std::size_t>(i); }

/// A triangle laid flat, or an equilateral one where it has no area.
std::array<Eigen::Vector2d, 3> flat(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double side = (b - a).norm(), twice_area = (b - a).cross(c - a).norm();
  if (twice_area < 1e-6 * ((b - a).squaredNorm() + (c - a).squaredNorm()))
    return {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), Eigen::Vector2d(0.5, 0.866)};
  return {Eigen::Vector2d(0, 0), Eigen::Vector2d(side, 0),
          Eigen::Vector2d((c - a).dot(b - a) / side, twice_area / side)};
}

/// What a source's finest triangles and edges are cut into, by numbers in the interpolator.
class SourceCuts {
 public:
  /// New vertices are numbered from `next` on.
  SourceCuts(const SourceSurface& source, const SubdivisionLevels& levels, int next)
      : surface_(source.surface),
        finest_(surface_.levels.simplices(surface_.levels.finest())),
        numbers_(source_numbers(source, levels)),
        next_(next),
        overlay_(surface_overlay(source.body, source.drawn, surface_.on_domain)) {
    for (const auto& [edge, nodes] : overlay_.on_edge) {
      const int low = numbers_[index(edge[0])], high = numbers_[index(edge[1])];
      std::vector<int>& chain = edges_[{std::min(low, high), std::max(low, high)}];
      chain.push_back(low);
      for (const int node : nodes) chain.push_back(next_ + node);
      chain.push_back(high);
      if (low > high) std::reverse(chain.begin(), chain.end());
    }
    std::vector<std::optional<Cut>> cuts(index(finest_.cols()));
    tbb::parallel_for(std::size_t{0}, cuts.size(), [&](std::size_t t) { cuts[t] = cut(static_cast<int>(t)); });
    for (std::optional<Cut>& made : cuts) {
      if (!made) continue;
      std::array<int, 3> key{made->corners[0], made->corners[1], made->corners[2]};
      std::sort(key.begin(), key.end());
      cuts_[key] = std::move(*made);
    }
  }

  const std::vector<int>& numbers() const { return numbers_; }
  const SurfaceOverlay& overlay() const { return overlay_; }

  /// A triangle's corners in some order, and what it is cut into, in the same order.
  struct Cut {
    Eigen::Vector3i corners;
    std::vector<Eigen::Vector3i> parts;
  };
  const Cut* cut_of(std::array<int, 3> corners) const {
    std::sort(corners.begin(), corners.end());
    const auto at = cuts_.find(corners);
    return at == cuts_.end() ? nullptr : &at->second;
  }
  /// From the lower number to the higher.
  const std::vector<int>* chain_of(int a, int b) const {
    const auto at = edges_.find({std::min(a, b), std::max(a, b)});
    return at == edges_.end() ? nullptr : &at->second;
  }

 private:
  std::optional<Cut> cut(int face) const {
    const auto inside = overlay_.inside.find(face);
    std::array<const std::vector<int>*, 3> on_sides{};
    bool is_cut = inside != overlay_.inside.end();
    for (int side = 0; side < 3; ++side) {
      const auto [low, high] = std::minmax(finest_(side, face), finest_((side + 1) % 3, face));
      const auto at = overlay_.on_edge.find({low, high});
      if (at == overlay_.on_edge.end()) continue;
      on_sides[index(side)] = &at->second;
      is_cut = true;
    }
    if (!is_cut) return std::nullopt;
    const auto place = [&](int c) { return surface_.places_mm.col(finest_(c, face)); };
    const std::array<Eigen::Vector2d, 3> corners = flat(place(0), place(1), place(2));
    FaceTriangulation made(corners);
    std::map<int, int> local;  // of added nodes
    Cut cut{{numbers_[index(finest_(0, face))], numbers_[index(finest_(1, face))], numbers_[index(finest_(2, face))]},
            {}};
    std::vector<int> numbers{cut.corners[0], cut.corners[1], cut.corners[2]};
    for (int side = 0; side < 3; ++side) {
      if (on_sides[index(side)] == nullptr) continue;
      const bool rising = finest_(side, face) < finest_((side + 1) % 3, face);
      for (const int node : *on_sides[index(side)]) {
        const double to_high = overlay_.added[index(node)].shares[0], way = rising ? to_high : 1 - to_high;
        local[node] = made.add_on_side(side, (1 - way) * corners[index(side)] + way * corners[index((side + 1) % 3)]);
        numbers.push_back(next_ + node);
      }
    }
    if (inside != overlay_.inside.end())
      for (const int node : inside->second) {
        const Eigen::Vector3d& shares = overlay_.added[index(node)].shares;
        local[node] = made.add_inside(shares[0] * corners[0] + shares[1] * corners[1] + shares[2] * corners[2]);
        numbers.push_back(next_ + node);
      }
    made.make_delaunay();
    join_pieces(face, local, made);
    made.make_delaunay();
    for (const Eigen::Vector3i& t : made.triangles())
      cut.parts.emplace_back(numbers[index(t[0])], numbers[index(t[1])], numbers[index(t[2])]);
    return cut;
  }

  void join_pieces(int face, const std::map<int, int>& local, FaceTriangulation& made) const {
    const auto pieces = overlay_.pieces.find(face);
    if (pieces == overlay_.pieces.end()) return;
    const auto number = [&](const SurfaceOverlay::Node& node) {
      if (node.is_added) return local.at(node.number);
      return finest_(0, face) == node.number ? 0 : finest_(1, face) == node.number ? 1 : 2;
    };
    for (const auto& [a, b] : pieces->second) made.join(number(a), number(b));
  }

  const SubdividedSurface& surface_;
  Eigen::MatrixXi finest_;
  std::vector<int> numbers_;
  int next_;
  SurfaceOverlay overlay_;
  std::map<std::array<int, 2>, std::vector<int>> edges_;
  std::map<std::array<int, 3>, Cut> cuts_;
};

/// The corners of a tetrahedron that belong to the source whose triangle they are, or fewer than three.
std::vector<Eigen::Index> corners_of(const Eigen::Vector4i& tetrahedron, const std::vector<char>& belongs) {
  std::vector<Eigen::Index> found;
  for (Eigen::Index c = 0; c < 4; ++c)
    if (belongs[index(tetrahedron[c])]) found.push_back(c);
  return found;
}

void add_cut(const Eigen::Vector4i& tetrahedron, const SourceCuts& cuts, const std::vector<char>& belongs,
             std::vector<Eigen::Vector4i>& made) {
  const std::vector<Eigen::Index> on = corners_of(tetrahedron, belongs);
  if (on.size() == 3) {
    if (const auto* cut = cuts.cut_of({tetrahedron[on[0]], tetrahedron[on[1]], tetrahedron[on[2]]})) {
      for (const Eigen::Vector3i& part : cut->parts) {
        Eigen::Vector4i& added = made.emplace_back(tetrahedron);
        for (const Eigen::Index c : on)
          for (int i = 0; i < 3; ++i)
            if (tetrahedron[c] == cut->corners[i]) added[c] = part[i];
      }
      return;
    }
  } else if (on.size() == 2) {
    if (const auto* chain = cuts.chain_of(tetrahedron[on[0]], tetrahedron[on[1]])) {
      const bool rising = tetrahedron[on[0]] < tetrahedron[on[1]];
      for (std::size_t i = 0; i + 1 < chain->size(); ++i) {
        Eigen::Vector4i& added = made.emplace_back(tetrahedron);
        added[on[0]] = (*chain)[rising ? i : i + 1];
        added[on[1]] = (*chain)[rising ? i + 1 : i];
      }
      return;
    }
  }
  made.push_back(tetrahedron);
}

}  // namespace

SimplicialMesh with_source_vertices(const SimplicialMesh& mesh, const BodyInterpolator& interpolator,
                                    const SubdivisionLevels& levels) {
  SimplicialMesh made = mesh;
  std::vector<Eigen::Vector4i> simplices;
  for (Eigen::Index s = 0; s < mesh.simplex_count(); ++s) simplices.emplace_back(mesh.simplices.col(s));
  for (const SourceSurface& source : interpolator.sources) {
    const Eigen::Index before = made.vertices.cols();
    const SourceCuts cuts(source, levels, static_cast<int>(before));
    const double t_mm = interpolator.base.vertices(3, source.vertices.front());
    const SurfaceOverlay& overlay = cuts.overlay();
    made.vertices.conservativeResize(4, before + static_cast<Eigen::Index>(overlay.added.size()));
    for (std::size_t i = 0; i < overlay.added.size(); ++i)
      made.vertices.col(before + static_cast<Eigen::Index>(i)) << overlay.added[i].place_mm, t_mm;
    for (const auto& [vertex, place_mm] : overlay.met)
      made.vertices.col(cuts.numbers()[index(vertex)]).head<3>() = place_mm;
    std::vector<char> belongs(index(made.vertices.cols()), 0);
    for (const int v : cuts.numbers()) belongs[index(v)] = 1;
    std::vector<Eigen::Vector4i> cut;
    for (const Eigen::Vector4i& s : simplices) add_cut(s, cuts, belongs, cut);
    simplices = std::move(cut);
  }
  made.simplices.resize(4, static_cast<Eigen::Index>(simplices.size()));
  for (std::size_t s = 0; s < simplices.size(); ++s) made.simplices.col(static_cast<Eigen::Index>(s)) = simplices[s];
  return made;
}

}  // namespace isostack
