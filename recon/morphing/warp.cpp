#include "recon/morphing/warp.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <utility>

#include "recon/geometry/errors.h"
#include "recon/solvers/interpolation_solver.h"

namespace isostack {

namespace {

/// Columns are the principal axes, the one along which the points spread most first: so the solver drops monomials of
/// axes the points do not span, whatever the coordinate system.
Eigen::MatrixXd principal_axes(const Eigen::MatrixXd& centred) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(centred * centred.transpose());
  return eigen.eigenvectors().rowwise().reverse();
}

Eigen::Index spanned_dimensions(const Eigen::MatrixXd& centred) {
  constexpr double nothing = 1e-6;  // of the largest extent
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(centred);
  svd.setThreshold(nothing);
  return svd.singularValues()[0] > 0 ? svd.rank() : 0;
}

/// As few points as determine a linear function: the one that varies along the axes they span only.
RadialWeights linear_through(const Eigen::MatrixXd& points, const Eigen::VectorXd& values) {
  const PolynomialBasis tail(1, points);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> least_norm(tail.values(points));
  return {Eigen::VectorXd::Zero(points.cols()), tail, least_norm.solve(values)};
}

std::vector<ImplicitFunction> interpolants(const Eigen::MatrixXd& places, const Eigen::MatrixXd& displacements) {
  const Kernel kernel = places.rows() == 2 ? thin_plate() : triharmonic();
  std::vector<ImplicitFunction> coordinates;
  if (places.cols() <= spanned_dimensions(places) + 1) {
    for (const auto& values : displacements.rowwise())
      coordinates.emplace_back(kernel, places, linear_through(places, values.transpose()));
    return coordinates;
  }
  const double extent = places.cwiseAbs().maxCoeff();
  InterpolationSolver solver({places, Eigen::VectorXd::Zero(places.cols()), {}},
                             {.kernel = kernel, .solver = SolverChoice::dense, .tolerance = 1e-9 * extent});
  for (const auto& values : displacements.rowwise()) {
    SolveReport report;
    const RadialWeights solution = solver.solve(values.transpose(), {}, report);
    if (!report.converged)
      throw SolveError("landmarks", "their displacements cannot be interpolated: some lie too close together",
                       "leave out one of each pair that is close");
    coordinates.emplace_back(kernel, solver.merged().set.points, solution);
  }
  return coordinates;
}

}  // namespace

Warp::Warp(const Eigen::MatrixXd& points, const Eigen::MatrixXd& displacements)
    : centre_(points.rowwise().mean()), axes_(principal_axes(points.colwise() - centre_)) {
  coordinates_ = interpolants(in_own_axes(points), displacements);
}

Eigen::MatrixXd Warp::in_own_axes(const Eigen::MatrixXd& points) const {
  return axes_.transpose() * (points.colwise() - centre_);
}

Eigen::MatrixXd Warp::displaced(const Eigen::MatrixXd& points, double amount) const {
  if (amount == 0) return points;
  const Eigen::MatrixXd places = in_own_axes(points);
  Eigen::MatrixXd result = points;
  for (std::size_t i = 0; i < coordinates_.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) += amount * coordinates_[i].values(places).transpose();
  return result;
}

std::vector<Eigen::MatrixXd> Warp::jacobians(const Eigen::MatrixXd& points, double amount) const {
  const Eigen::Index n = points.rows();
  std::vector<Eigen::MatrixXd> result(static_cast<std::size_t>(points.cols()), Eigen::MatrixXd::Identity(n, n));
  const Eigen::MatrixXd places = in_own_axes(points);
  for (Eigen::Index row = 0; row < n; ++row) {
    const Eigen::MatrixXd gradients = axes_ * coordinates_[static_cast<std::size_t>(row)].gradients(places);
    for (Eigen::Index p = 0; p < points.cols(); ++p)
      result[static_cast<std::size_t>(p)].row(row) += amount * gradients.col(p).transpose();
  }
  return result;
}

Eigen::MatrixXd Warp::undisplaced(const Eigen::MatrixXd& points, double amount) const {
  if (amount == 0 || points.cols() == 0) return points;
  constexpr int most_steps = 60;
  const double extent = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
  const double close = 1e-10 * std::max(extent, 1.0);
  Eigen::MatrixXd found = points, off = displaced(found, amount) - points;
  Eigen::VectorXd damping = Eigen::VectorXd::Ones(points.cols());
  bool folds = false;
  for (int step = 0; step < most_steps; ++step) {
    const std::vector<Eigen::MatrixXd> slopes = jacobians(found, amount);
    folds = false;
    Eigen::MatrixXd next = found;
    for (Eigen::Index p = 0; p < points.cols(); ++p) {
      const Eigen::MatrixXd& slope = slopes[static_cast<std::size_t>(p)];
      folds = folds || !(slope.determinant() > 0);
      next.col(p) -= damping[p] * slope.partialPivLu().solve(off.col(p));
    }
    if (!folds && off.colwise().norm().maxCoeff() <= close) return found;
    const Eigen::MatrixXd next_off = displaced(next, amount) - points;
    for (Eigen::Index p = 0; p < points.cols(); ++p) {
      const bool is_closer = next_off.col(p).norm() < off.col(p).norm() || off.col(p).norm() <= close;
      damping[p] = is_closer ? std::min(1.0, 2 * damping[p]) : damping[p] / 2;
      if (is_closer) found.col(p) = next.col(p), off.col(p) = next_off.col(p);
    }
  }
  throw GeometryError(
      "landmarks",
      folds ? "the displacement they ask for folds the shape over" : "the displacement they ask for cannot be undone",
      "move the landmarks so that they keep their order, or use fewer");
}

}  // namespace isostack
