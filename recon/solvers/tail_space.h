#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "recon/kernels/polynomial.h"

namespace isostack {

/// The polynomials of a tail on a set of points: an orthonormal basis of their values, in which
/// monomials that depend on the others there (points on a quadric, …) do not count.
class TailSpace {
 public:
  /// `points` is n × N.
  TailSpace(const PolynomialBasis& basis, const Eigen::MatrixXd& points);

  Eigen::Index rank() const { return values_.cols(); }
  /// Removes the polynomial part of one value per point; returns that part's monomial coefficients.
  Eigen::VectorXd remove_from(Eigen::VectorXd& values) const;
  /// Points, one per dimension of the space, whose values determine a polynomial well.
  std::vector<std::uint32_t> determining_points() const;

 private:
  Eigen::MatrixXd values_;        ///< N × rank, orthonormal columns
  Eigen::MatrixXd coefficients_;  ///< size() × rank: monomials to orthonormal columns
};

/// Σ a_i b_i in an order that does not depend on the number of threads.
double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

}  // namespace isostack
