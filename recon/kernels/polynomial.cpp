#include "recon/kernels/polynomial.h"

#include <vector>

namespace isostack {

namespace {

void append_exponents(Eigen::VectorXi& prefix, Eigen::Index axis, int remaining, std::vector<Eigen::VectorXi>& out) {
  if (axis == prefix.size()) {
    out.push_back(prefix);
    return;
  }
  for (int power = 0; power <= remaining; ++power) {
    prefix[axis] = power;
    append_exponents(prefix, axis + 1, remaining - power, out);
  }
  prefix[axis] = 0;
}

double monomial(const Eigen::ArrayXd& x, const Eigen::VectorXi& exponents) {
  double value = 1;
  for (Eigen::Index axis = 0; axis < x.size(); ++axis)
    for (int power = 0; power < exponents[axis]; ++power) value *= x[axis];
  return value;
}

}  // namespace

PolynomialBasis::PolynomialBasis(int degree, const Eigen::MatrixXd& points) {
  const Eigen::VectorXd low = points.rowwise().minCoeff();
  const Eigen::VectorXd high = points.rowwise().maxCoeff();
  centre_ = (low + high) / 2;
  const double half_extent = (high - low).maxCoeff() / 2;
  scale_ = half_extent > 0 ? 1 / half_extent : 1;

  std::vector<Eigen::VectorXi> all;
  Eigen::VectorXi prefix = Eigen::VectorXi::Zero(points.rows());
  append_exponents(prefix, 0, degree, all);
  exponents_.resize(points.rows(), static_cast<Eigen::Index>(all.size()));
  for (Eigen::Index q = 0; q < exponents_.cols(); ++q) exponents_.col(q) = all[static_cast<std::size_t>(q)];
}

Eigen::ArrayXd PolynomialBasis::scaled(const Eigen::MatrixXd& points, Eigen::Index column) const {
  return ((points.col(column) - centre_) * scale_).array();
}

Eigen::MatrixXd PolynomialBasis::values(const Eigen::MatrixXd& points) const {
  Eigen::MatrixXd result(points.cols(), size());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::ArrayXd x = scaled(points, i);
    for (Eigen::Index q = 0; q < size(); ++q) result(i, q) = monomial(x, exponents_.col(q));
  }
  return result;
}

Eigen::MatrixXd PolynomialBasis::gradients(const Eigen::MatrixXd& points, const Eigen::VectorXd& coefficients) const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(points.rows(), points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::ArrayXd x = scaled(points, i);
    for (Eigen::Index q = 0; q < size(); ++q)
      for (Eigen::Index axis = 0; axis < points.rows(); ++axis) {
        Eigen::VectorXi lowered = exponents_.col(q);
        const int power = lowered[axis]--;
        if (power > 0) result(axis, i) += power * scale_ * coefficients[q] * monomial(x, lowered);
      }
  }
  return result;
}

}  // namespace isostack
