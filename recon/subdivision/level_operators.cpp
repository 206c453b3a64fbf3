#include "recon/subdivision/level_operators.h"

#include <tbb/parallel_for.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "recon/subdivision/simplex_subdivision.h"

namespace isostack {

namespace {

/// What a simplex with `corners` corners, in as many dimensions, adds to the sums.
template <int corners>
struct SimplexShare {
  using Square = Eigen::Matrix<double, corners, corners>;
  Square stiffness, along_t;
  double content = 0;
};

template <int corners>
SimplexShare<corners> share_of(const SimplicialMesh& mesh, Eigen::Index simplex) {
  constexpr int size = corners - 1;
  Eigen::Matrix<double, corners, size> sides;
  for (int i = 0; i < size; ++i)
    sides.col(i) = mesh.vertices.col(mesh.simplices(i + 1, simplex)) - mesh.vertices.col(mesh.simplices(0, simplex));
  const Eigen::Matrix<double, size, size> gram = sides.transpose() * sides;
  typename SimplexShare<corners>::Square gradients;  // of the corners' functions
  gradients.template rightCols<size>() = sides * gram.inverse();
  gradients.col(0) = -gradients.template rightCols<size>().rowwise().sum();
  SimplexShare<corners> share;
  share.content = std::sqrt(gram.determinant()) / (size == 2 ? 2 : 6);
  share.stiffness = share.content * gradients.transpose() * gradients;
  // Within the simplex t grows along the gradient of t, which is linear there.
  const Eigen::Matrix<double, corners, 1> upwards = gradients.template rightCols<size>() * sides.row(size).transpose();
  const Eigen::Matrix<double, corners, 1> along = gradients.transpose() * upwards.normalized();
  share.along_t = share.content * along * along.transpose();
  return share;
}

}  // namespace

LevelOperators::LevelOperators(const SimplicialMesh& mesh) {
  mass_ = Eigen::VectorXd::Zero(mesh.vertex_count());
  set_neighbours(mesh.simplices);
  stiffness_.assign(neighbour_.size(), 0);
  stiffness_along_t_.assign(neighbour_.size(), 0);
  if (mesh.simplices.rows() == 3)
    add_simplices<3>(mesh);
  else
    add_simplices<4>(mesh);
  set_beside(mesh);
}

void LevelOperators::set_beside(const SimplicialMesh& mesh) {
  constexpr double same_t = 1e-9;  // of an edge's length
  beside_.assign(neighbour_.size(), 0);
  beside_length_ = Eigen::VectorXd::Zero(vertex_count());
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(vertex_count());
  const Eigen::Index t = mesh.dimension() - 1;
  tbb::parallel_for(Eigen::Index{0}, vertex_count(), [&](Eigen::Index v) {
    const auto row = static_cast<std::size_t>(v);
    for (std::size_t i = begin_[row]; i < begin_[row + 1]; ++i) {
      const Eigen::VectorXd way = mesh.vertices.col(neighbour_[i]) - mesh.vertices.col(v);
      if (std::abs(way[t]) >= same_t * way.norm()) continue;
      beside_[i] = 1 / way.norm();
      beside_length_[v] += way.norm() / 2;
      sum[v] += beside_[i];
    }
  });
  // Rows' sums of the step's matrix without signs are at most these.
  filter_scale_ = Eigen::VectorXd::Zero(vertex_count());
  for (Eigen::Index v = 0; v < vertex_count(); ++v) {
    if (!(sum[v] > 0)) continue;
    const auto row = static_cast<std::size_t>(v);
    double bound = 2 * sum[v] * sum[v] / beside_length_[v];
    for (std::size_t i = begin_[row]; i < begin_[row + 1]; ++i)
      if (beside_[i] > 0) bound += 2 * beside_[i] * sum[neighbour_[i]] / beside_length_[neighbour_[i]];
    filter_scale_[v] = 1 / bound;
  }
}

void LevelOperators::set_neighbours(const Eigen::MatrixXi& simplices) {
  const auto edges = subdivide(simplices, vertex_count()).edges;
  begin_.assign(static_cast<std::size_t>(vertex_count()) + 1, 0);
  for (const auto& [a, b] : edges) {
    ++begin_[static_cast<std::size_t>(a) + 1];
    ++begin_[static_cast<std::size_t>(b) + 1];
  }
  for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
  neighbour_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (const auto& [a, b] : edges) {  // sorted: a row's lower neighbours come before its higher ones
    neighbour_[next[static_cast<std::size_t>(b)]++] = a;
  }
  for (const auto& [a, b] : edges) neighbour_[next[static_cast<std::size_t>(a)]++] = b;
}

std::size_t LevelOperators::entry(int row, int column) const {
  const auto from = neighbour_.begin() + static_cast<std::ptrdiff_t>(begin_[static_cast<std::size_t>(row)]);
  const auto to = neighbour_.begin() + static_cast<std::ptrdiff_t>(begin_[static_cast<std::size_t>(row) + 1]);
  return static_cast<std::size_t>(std::lower_bound(from, to, column) - neighbour_.begin());
}

template <int corners>
void LevelOperators::add_simplices(const SimplicialMesh& mesh) {
  for (Eigen::Index s = 0; s < mesh.simplex_count(); ++s) {
    const SimplexShare<corners> share = share_of<corners>(mesh, s);
    for (int i = 0; i < corners; ++i) {
      const int v = mesh.simplices(i, s);
      mass_[v] += share.content / corners;
      for (int j = 0; j < corners; ++j) {
        if (i == j) continue;
        const std::size_t at = entry(v, mesh.simplices(j, s));
        stiffness_[at] += share.stiffness(i, j);
        stiffness_along_t_[at] += share.along_t(i, j);
      }
    }
  }
}

template <int rows>
Eigen::MatrixXd LevelOperators::weighted_rows(const std::vector<double>& weights, const Eigen::MatrixXd& x) const {
  const Eigen::Map<const Eigen::Matrix<double, rows, Eigen::Dynamic>> from(x.data(), rows, x.cols());
  Eigen::Matrix<double, rows, Eigen::Dynamic> result(rows, x.cols());
  tbb::parallel_for(Eigen::Index{0}, x.cols(), [&](Eigen::Index v) {
    const auto row = static_cast<std::size_t>(v);
    const Eigen::Matrix<double, rows, 1> here = from.col(v);
    Eigen::Matrix<double, rows, 1> sum = Eigen::Matrix<double, rows, 1>::Zero();
    for (std::size_t i = begin_[row]; i < begin_[row + 1]; ++i) sum += weights[i] * (from.col(neighbour_[i]) - here);
    result.col(v) = sum;
  });
  return result;
}

Eigen::MatrixXd LevelOperators::weighted(const std::vector<double>& weights, const Eigen::MatrixXd& x) const {
  return x.rows() == 2 ? weighted_rows<2>(weights, x) : weighted_rows<3>(weights, x);
}

Eigen::SparseMatrix<double> LevelOperators::stiffness_columns(const std::vector<int>& number, int count) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t row = 0; row + 1 < begin_.size(); ++row) {
    double diagonal = 0;
    for (std::size_t i = begin_[row]; i < begin_[row + 1]; ++i) {
      diagonal -= stiffness_[i];
      const int column = number[static_cast<std::size_t>(neighbour_[i])];
      if (column >= 0) entries.emplace_back(static_cast<int>(row), column, stiffness_[i]);
    }
    if (number[row] >= 0) entries.emplace_back(static_cast<int>(row), number[row], diagonal);
  }
  Eigen::SparseMatrix<double> result(vertex_count(), count);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Eigen::VectorXd LevelOperators::bending_diagonal(const Eigen::VectorXd& counted) const {
  Eigen::VectorXd result(vertex_count());
  tbb::parallel_for(Eigen::Index{0}, vertex_count(), [&](Eigen::Index v) {
    const auto row = static_cast<std::size_t>(v);
    double diagonal = 0, sum = 0;
    for (std::size_t i = begin_[row]; i < begin_[row + 1]; ++i) {
      diagonal -= stiffness_[i];
      sum += stiffness_[i] * stiffness_[i] * counted[neighbour_[i]] / mass_[neighbour_[i]];
    }
    result[v] = sum + diagonal * diagonal * counted[v] / mass_[v];
  });
  return result;
}

Eigen::MatrixXd LevelOperators::filter_step(const Eigen::MatrixXd& x) const {
  const Eigen::VectorXd per_length =
      (beside_length_.array() > 0).select(beside_length_.cwiseInverse(), Eigen::VectorXd::Zero(vertex_count()));
  const Eigen::MatrixXd curvature = weighted(beside_, x) * per_length.asDiagonal();
  return weighted(beside_, curvature) * filter_scale_.asDiagonal();
}

}  // namespace isostack
