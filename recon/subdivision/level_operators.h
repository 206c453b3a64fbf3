#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "recon/subdivision/simplicial_mesh.h"

namespace isostack {

/// Sums over neighbours on one level of an interpolator. A row's neighbours are those of its vertex, ascending.
class LevelOperators {
 public:
  /// Lengths are those of `mesh` as it is given, t in mm. Simplices must have a content above 0.
  explicit LevelOperators(const SimplicialMesh& mesh);

  Eigen::Index vertex_count() const { return mass_.size(); }
  const Eigen::VectorXd& mass() const { return mass_; }  ///< each vertex's share of its simplices, mm² or mm³

  /// K x with K = ∫ ∇φᵢ·∇φⱼ: minus the Laplacian times the mass. One column per vertex, as everywhere.
  Eigen::MatrixXd stiffness(const Eigen::MatrixXd& x) const { return weighted(stiffness_, x); }
  /// The part of K that is along t, up the interpolator.
  Eigen::MatrixXd stiffness_along_t(const Eigen::MatrixXd& x) const { return weighted(stiffness_along_t_, x); }
  /// The columns of K that have a number (from 0 on), in that order; others are -1.
  Eigen::SparseMatrix<double> stiffness_columns(const std::vector<int>& number, int count) const;
  /// Diagonal of K R M⁻¹ K, where R keeps the rows that are counted.
  Eigen::VectorXd bending_diagonal(const Eigen::VectorXd& counted) const;

  /// One step of Taubin's filter among neighbours of the same t, to be taken from x: that of bending Σ mᵢ |cᵢ|² with
  /// the curvature c at each vertex, which leaves alone what is evenly curved. Whatever alternates from neighbour to
  /// neighbour goes in one step.
  Eigen::MatrixXd filter_step(const Eigen::MatrixXd& x) const;

 private:
  Eigen::MatrixXd weighted(const std::vector<double>& weights, const Eigen::MatrixXd& x) const;
  template <int rows>
  Eigen::MatrixXd weighted_rows(const std::vector<double>& weights, const Eigen::MatrixXd& x) const;
  void set_neighbours(const Eigen::MatrixXi& simplices);
  std::size_t entry(int row, int column) const;
  template <int corners>
  void add_simplices(const SimplicialMesh& mesh);
  void set_beside(const SimplicialMesh& mesh);

  Eigen::VectorXd mass_;
  std::vector<std::size_t> begin_;  ///< of each row
  std::vector<int> neighbour_;
  std::vector<double> stiffness_, stiffness_along_t_;  ///< of each neighbour
  std::vector<double> beside_;                         ///< 1 / distance of neighbours of the same t, 0 of others
  Eigen::VectorXd beside_length_, filter_scale_;       ///< of each vertex: half the way to them; what makes a step safe
};

}  // namespace isostack
