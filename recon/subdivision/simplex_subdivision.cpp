#include "recon/subdivision/simplex_subdivision.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>

namespace isostack {

namespace {

/// The edges of a mesh, found by their ends.
class EdgeTable {
 public:
  EdgeTable(const Eigen::MatrixXi& simplices, Eigen::Index vertex_count);

  std::vector<std::array<int, 2>> edges() const;
  int number_of(int a, int b) const;

 private:
  std::span<int> above(std::size_t low) {
    return {high_.data() + begin_[low], static_cast<std::size_t>(end_[low] - begin_[low])};
  }

  /// Edges of `low` are high_[begin_[low] ... end_[low]), ascending, and have the numbers from first_[low] on.
  std::vector<Eigen::Index> begin_, end_, first_;
  std::vector<int> high_;
};

template <class Visit>
void for_each_edge(const Eigen::MatrixXi& simplices, Visit visit) {
  for (Eigen::Index s = 0; s < simplices.cols(); ++s)
    for (Eigen::Index i = 0; i < simplices.rows(); ++i)
      for (Eigen::Index j = i + 1; j < simplices.rows(); ++j)
        visit(std::min(simplices(i, s), simplices(j, s)), std::max(simplices(i, s), simplices(j, s)));
}

EdgeTable::EdgeTable(const Eigen::MatrixXi& simplices, Eigen::Index vertex_count) {
  const auto count = static_cast<std::size_t>(vertex_count);
  begin_.assign(count + 1, 0);
  for_each_edge(simplices, [&](int low, int) { ++begin_[static_cast<std::size_t>(low) + 1]; });
  for (std::size_t v = 0; v < count; ++v) begin_[v + 1] += begin_[v];
  high_.resize(static_cast<std::size_t>(begin_[count]));
  end_.assign(begin_.begin(), begin_.end() - 1);
  for_each_edge(simplices, [&](int low, int high) {
    high_[static_cast<std::size_t>(end_[static_cast<std::size_t>(low)]++)] = high;
  });
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t v) {
    const std::span<int> ends = above(v);
    std::sort(ends.begin(), ends.end());
    end_[v] = begin_[v] + (std::unique(ends.begin(), ends.end()) - ends.begin());
  });
  first_.assign(count + 1, 0);
  for (std::size_t v = 0; v < count; ++v) first_[v + 1] = first_[v] + end_[v] - begin_[v];
}

std::vector<std::array<int, 2>> EdgeTable::edges() const {
  std::vector<std::array<int, 2>> edges;
  edges.reserve(static_cast<std::size_t>(first_.back()));
  for (std::size_t v = 0; v < end_.size(); ++v)
    for (Eigen::Index i = begin_[v]; i < end_[v]; ++i)
      edges.push_back({static_cast<int>(v), high_[static_cast<std::size_t>(i)]});
  return edges;
}

int EdgeTable::number_of(int a, int b) const {
  const auto low = static_cast<std::size_t>(std::min(a, b));
  const auto from = high_.begin() + begin_[low];
  return static_cast<int>(first_[low] + (std::lower_bound(from, high_.begin() + end_[low], std::max(a, b)) - from));
}

void cut_triangle(const Eigen::Ref<const Eigen::Vector3i>& t, const std::array<int, 3>& middle,
                  Eigen::Ref<Eigen::MatrixXi> parts) {
  const auto [m01, m02, m12] = middle;
  parts.col(0) << t[0], m01, m02;
  parts.col(1) << m01, t[1], m12;
  parts.col(2) << m02, m12, t[2];
  parts.col(3) << m01, m12, m02;
}

/// The order of a part's vertices decides its own next cut. It is that of a chain of corners of cubes, which a shift
/// in a circle leaves alone; two parts are shifted so that all keep the whole's orientation.
void cut_tetrahedron(const Eigen::Ref<const Eigen::Vector4i>& t, const std::array<int, 6>& middle,
                     Eigen::Ref<Eigen::MatrixXi> parts) {
  const auto [m01, m02, m03, m12, m13, m23] = middle;
  parts.col(0) << t[0], m01, m02, m03;
  parts.col(1) << m01, t[1], m12, m13;
  parts.col(2) << m02, m12, t[2], m23;
  parts.col(3) << m03, m13, m23, t[3];
  parts.col(4) << m01, m02, m03, m13;
  parts.col(5) << m02, m12, m13, m01;
  parts.col(6) << m02, m03, m13, m23;
  parts.col(7) << m12, m13, m23, m02;
}

template <std::size_t edge_count>
std::array<int, edge_count> middles(const EdgeTable& table, const Eigen::VectorXi& simplex, Eigen::Index coarse_count) {
  std::array<int, edge_count> result;
  std::size_t next = 0;
  for (Eigen::Index i = 0; i < simplex.size(); ++i)
    for (Eigen::Index j = i + 1; j < simplex.size(); ++j)
      result[next++] = static_cast<int>(coarse_count) + table.number_of(simplex[i], simplex[j]);
  return result;
}

}  // namespace

SimplexSubdivision subdivide(const Eigen::MatrixXi& simplices, Eigen::Index vertex_count) {
  if (simplices.rows() != 3 && simplices.rows() != 4) throw std::invalid_argument("triangles or tetrahedra only");
  const EdgeTable table(simplices, vertex_count);
  SimplexSubdivision result;
  result.edges = table.edges();
  const Eigen::Index parts = simplices.rows() == 3 ? 4 : 8;
  result.simplices.resize(simplices.rows(), parts * simplices.cols());
  tbb::parallel_for(Eigen::Index{0}, simplices.cols(), [&](Eigen::Index s) {
    const Eigen::VectorXi simplex = simplices.col(s);
    auto cut = result.simplices.middleCols(parts * s, parts);
    if (simplices.rows() == 3)
      cut_triangle(simplex, middles<3>(table, simplex, vertex_count), cut);
    else
      cut_tetrahedron(simplex, middles<6>(table, simplex, vertex_count), cut);
  });
  return result;
}

Eigen::MatrixXd midpoint_refined(const Eigen::MatrixXd& vertices, const SimplexSubdivision& subdivision) {
  Eigen::MatrixXd result(vertices.rows(), vertices.cols() + static_cast<Eigen::Index>(subdivision.edges.size()));
  result.leftCols(vertices.cols()) = vertices;
  tbb::parallel_for(std::size_t{0}, subdivision.edges.size(), [&](std::size_t e) {
    const auto [a, b] = subdivision.edges[e];
    result.col(vertices.cols() + static_cast<Eigen::Index>(e)) = (vertices.col(a) + vertices.col(b)) / 2;
  });
  return result;
}

}  // namespace isostack
