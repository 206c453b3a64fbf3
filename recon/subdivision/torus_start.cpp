#include "recon/subdivision/torus_start.h"

#include <Eigen/Dense>
#include <deque>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace isostack {

namespace {

using Edge = std::pair<int, int>;  // low, high

Edge edge_of(int a, int b) { return std::minmax(a, b); }

/// Vertex differences over the edges (low → high), in periods: 0 along a tree, closed round every triangle.
class PeriodForm {
 public:
  explicit PeriodForm(const std::vector<Eigen::Vector3i>& triangles) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (triangles[t][0] < 0) continue;
      faces_.push_back(triangles[t]);
      for (int c = 0; c < 3; ++c)
        faces_of_[edge_of(triangles[t][c], triangles[t][(c + 1) % 3])].push_back(static_cast<int>(faces_.size()) - 1);
    }
    grow_trees();
    for (int period = 0; period < 2; ++period) solve(period);
  }

  Eigen::Vector2i along(int from, int to) const {
    const Eigen::Vector2i& value = values_.at(edge_of(from, to));
    return from < to ? value : Eigen::Vector2i(-value);
  }
  const std::map<Edge, Eigen::Vector2i>& values() const { return values_; }

 private:
  /// A tree through the vertices, a tree through the triangles that does not cross it; two edges are in neither.
  void grow_trees() {
    std::set<int> reached{faces_.front()[0]};
    for (bool grew = true; grew;) {
      grew = false;
      for (const auto& [edge, sides] : faces_of_)
        if (reached.count(edge.first) != reached.count(edge.second)) {
          reached.insert({edge.first, edge.second});
          tree_.insert(edge);
          grew = true;
        }
    }
    std::set<int> faces{0};
    for (bool grew = true; grew;) {
      grew = false;
      for (const auto& [edge, sides] : faces_of_)
        if (tree_.count(edge) == 0 && faces.count(sides[0]) != faces.count(sides[1])) {
          faces.insert({sides[0], sides[1]});
          crossed_.insert(edge);
          grew = true;
        }
    }
    for (const auto& [edge, sides] : faces_of_)
      if (tree_.count(edge) == 0 && crossed_.count(edge) == 0) loops_.push_back(edge);
  }

  /// Triangle by triangle, each with one edge unknown: leaves of the triangles' tree first.
  void solve(int period) {
    std::map<Edge, int> known;
    for (const Edge& edge : tree_) known[edge] = 0;
    for (std::size_t l = 0; l < loops_.size(); ++l) known[loops_[l]] = static_cast<int>(l) == period ? 1 : 0;
    for (bool grew = true; grew;) {
      grew = false;
      for (const Eigen::Vector3i& face : faces_) {
        int sum = 0, unknown = -1, count = 0;
        for (int c = 0; c < 3; ++c) {
          const int a = face[c], b = face[(c + 1) % 3];
          const auto found = known.find(edge_of(a, b));
          if (found == known.end()) {
            unknown = c;
            ++count;
          } else {
            sum += a < b ? found->second : -found->second;
          }
        }
        if (count != 1) continue;
        const int a = face[unknown], b = face[(unknown + 1) % 3];
        known[edge_of(a, b)] = a < b ? -sum : sum;
        grew = true;
      }
    }
    for (const auto& [edge, value] : known) {
      Eigen::Vector2i& both = values_.try_emplace(edge, Eigen::Vector2i::Zero()).first->second;
      both[period] = value;
    }
  }

  std::vector<Eigen::Vector3i> faces_;
  std::map<Edge, std::vector<int>> faces_of_;
  std::set<Edge> tree_, crossed_;
  std::vector<Edge> loops_;
  std::map<Edge, Eigen::Vector2i> values_;
};

/// Every vertex the mean of its neighbours' nearest copies.
std::vector<Eigen::Vector3d> harmonic_positions(const PeriodForm& form, int vertices) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Identity(vertices, vertices) * 1e-30;
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(vertices, 2);
  for (const auto& [edge, period] : form.values()) {
    const auto [low, high] = edge;
    a(low, low) += 1;
    a(high, high) += 1;
    a(low, high) -= 1;
    a(high, low) -= 1;
    b.row(low) += period.cast<double>().transpose();
    b.row(high) -= period.cast<double>().transpose();
  }
  const int first = form.values().begin()->first.first;
  a(first, first) += 1;  // which stays at 0
  const Eigen::MatrixXd solved = a.ldlt().solve(b);
  std::vector<Eigen::Vector3d> positions;
  for (int v = 0; v < vertices; ++v) positions.emplace_back(solved(v, 0), solved(v, 1), 1);
  return positions;
}

}  // namespace

DomainMesh torus_start(const std::vector<Eigen::Vector3i>& triangles, int vertices) {
  // Only the corners that occur are solved for.
  std::vector<int> compact(static_cast<std::size_t>(vertices), -1), original;
  std::vector<Eigen::Vector3i> faces = triangles;
  for (Eigen::Vector3i& t : faces)
    for (int& v : t) {
      if (v < 0) continue;
      int& number = compact[static_cast<std::size_t>(v)];
      if (number < 0) {
        number = static_cast<int>(original.size());
        original.push_back(v);
      }
      v = number;
    }
  const PeriodForm form(faces);
  const std::vector<Eigen::Vector3d> solved = harmonic_positions(form, static_cast<int>(original.size()));

  DomainMesh made;
  made.domain.genus = 1;
  made.domain.periods << 1, 0, 0, 1, 0, 0;
  made.positions.assign(static_cast<std::size_t>(vertices), Eigen::Vector3d::Zero());
  for (std::size_t v = 0; v < original.size(); ++v) made.positions[static_cast<std::size_t>(original[v])] = solved[v];
  made.triangles = triangles;
  double area = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    CornerOffsets& offsets = made.offsets.emplace_back();
    offsets.fill(Eigen::Vector2i::Zero());
    if (triangles[t][0] < 0) continue;
    for (std::size_t c = 1; c < 3; ++c) offsets[c] = form.along(faces[t][0], faces[t][static_cast<Eigen::Index>(c)]);
    const int number = static_cast<int>(t);
    area += made.domain.orientation(made.corner(number, 0, 0), made.corner(number, 1, 0), made.corner(number, 2, 0));
  }
  if (area > 0) return made;
  for (Eigen::Vector3d& p : made.positions) p.x() = -p.x();  // it was seen from below
  made.domain.periods(0, 0) = -1;
  return made;
}

}  // namespace isostack
