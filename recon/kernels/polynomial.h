#pragma once

#include <Eigen/Core>

namespace isostack {

/// The monomials of degree ≤ d in n variables, in coordinates centred and scaled to the points
/// they are built for, so that they stay well conditioned in any unit and far from the origin.
class PolynomialBasis {
 public:
  PolynomialBasis() = default;
  /// `points` is n × N, one point a column.
  PolynomialBasis(int degree, const Eigen::MatrixXd& points);

  Eigen::Index size() const { return exponents_.cols(); }
  /// Values of every monomial: M × size() for n × M points.
  Eigen::MatrixXd values(const Eigen::MatrixXd& points) const;
  /// Gradient of Σ coefficients_q · monomial_q: n × M for n × M points.
  Eigen::MatrixXd gradients(const Eigen::MatrixXd& points, const Eigen::VectorXd& coefficients) const;

 private:
  Eigen::ArrayXd scaled(const Eigen::MatrixXd& points, Eigen::Index column) const;

  Eigen::VectorXd centre_;
  double scale_ = 1;
  Eigen::MatrixXi exponents_;  ///< n × size()
};

}  // namespace isostack
