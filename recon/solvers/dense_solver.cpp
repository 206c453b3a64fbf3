#include "recon/solvers/dense_solver.h"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <Eigen/QR>
#include <algorithm>

#include "recon/geometry/errors.h"
#include "recon/solvers/cholesky.h"
#include "recon/solvers/direct_sum.h"
#include "recon/solvers/lapack.h"
#include "recon/solvers/memory_limit.h"
#include "recon/solvers/thread_count.h"

namespace isostack {

namespace {

/// Lower triangle of sign · (φ + sign·ρ).
Eigen::MatrixXd signed_kernel_matrix(const Kernel& kernel, const Eigen::MatrixXd& points,
                                     const Eigen::VectorXd& smoothing) {
  const Eigen::Index count = points.cols();
  const double sign = kernel.sign();
  Eigen::MatrixXd matrix(count, count);
  tbb::parallel_for(tbb::blocked_range<Eigen::Index>(0, count, 32), [&](const auto& range) {
    for (Eigen::Index j = range.begin(); j < range.end(); ++j) {
      for (Eigen::Index i = j; i < count; ++i)
        matrix(i, j) = sign * kernel.value((points.col(i) - points.col(j)).squaredNorm());
      if (smoothing.size() > 0) matrix(j, j) += smoothing[j];
    }
  });
  return matrix;
}

/// Rows that one task works on: the same whatever the number of threads, so that sums round the same.
constexpr Eigen::Index rows_at_once = 256;

template <class Work>
void for_row_blocks(Eigen::Index count, const Work& work) {
  tbb::parallel_for(Eigen::Index{0}, (count + rows_at_once - 1) / rows_at_once, [&](Eigen::Index block) {
    const Eigen::Index first = block * rows_at_once;
    work(first, std::min(rows_at_once, count - first));
  });
}

/// A symmetric matrix, of which the lower triangle is there, times a few columns.
Eigen::MatrixXd times_symmetric(const Eigen::MatrixXd& lower, const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd product(columns.rows(), columns.cols());
  for_row_blocks(lower.rows(), [&](Eigen::Index first, Eigen::Index rows) {
    const Eigen::Index below = first + rows, rest = lower.rows() - below;
    auto part = product.middleRows(first, rows);
    part.noalias() =
        lower.block(first, first, rows, rows).selfadjointView<Eigen::Lower>() * columns.middleRows(first, rows);
    part.noalias() += lower.block(first, 0, rows, first) * columns.topRows(first);
    part.noalias() += lower.block(below, first, rest, rows).transpose() * columns.bottomRows(rest);
  });
  return product;
}

/// lower -= V Yᵀ + Y Vᵀ, on and below the diagonal.
void subtract_products(const Eigen::MatrixXd& v, const Eigen::MatrixXd& y, Eigen::MatrixXd& lower) {
  for_row_blocks(lower.rows(), [&](Eigen::Index first, Eigen::Index rows) {
    auto left = lower.block(first, 0, rows, first);
    left.noalias() -= v.middleRows(first, rows) * y.topRows(first).transpose();
    left.noalias() -= y.middleRows(first, rows) * v.topRows(first).transpose();
    auto diagonal = lower.block(first, first, rows, rows).triangularView<Eigen::Lower>();
    diagonal -= v.middleRows(first, rows) * y.middleRows(first, rows).transpose();
    diagonal -= y.middleRows(first, rows) * v.middleRows(first, rows).transpose();
  });
}

/// Which monomials are independent on the points (all of them unless the points are degenerate,
/// e.g. in one plane).
std::vector<Eigen::Index> independent_columns(const Eigen::MatrixXd& values) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(values);
  qr.setThreshold(1e-10);
  std::vector<Eigen::Index> kept;
  for (Eigen::Index q = 0; q < qr.rank(); ++q) kept.push_back(qr.colsPermutation().indices()[q]);
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace

std::size_t DenseSolver::required_bytes(std::size_t constraint_count) {
  // The matrix is factored in place; the reflectors and one workspace add a few dozen columns.
  return constraint_count * (constraint_count + 64) * sizeof(double);
}

DenseSolver::DenseSolver(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& smoothing,
                         const Options& options, const Progress& progress)
    : kernel_(kernel), points_(points), smoothing_(smoothing), tail_(kernel.tail_degree, points) {
  const auto count = static_cast<std::size_t>(points.cols());
  require_memory(count, required_bytes(count), options.memory_limit_bytes);
  const Eigen::MatrixXd monomials = tail_.values(points);
  kept_ = independent_columns(monomials);
  tail_values_ = monomials(Eigen::all, kept_);
  factorise(progress);
}

void DenseSolver::factorise(const Progress& progress) {
  progress.report("solve", 0.0);
  const OneBlasThread one_thread;
  const Eigen::Index rank = tail_values_.cols();
  const int count = static_cast<int>(points_.cols());
  if (count <= rank)
    throw SolveError("dense solve", fmt::format("{} constraints do not determine a surface", count),
                     "give more slices or contours with more points");

  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(tail_values_);
  reflectors_ = qr.matrixQR().triangularView<Eigen::UnitLower>();
  triangle_ = Eigen::MatrixXd::Zero(rank, rank);
  for (Eigen::Index q = 0; q < rank; ++q) {  // compact WY form of the product of reflections
    const double tau = qr.hCoeffs()[q];
    triangle_(q, q) = tau;
    triangle_.col(q).head(q) =
        -tau * triangle_.topLeftCorner(q, q) * (reflectors_.leftCols(q).transpose() * reflectors_.col(q));
  }

  factor_ = signed_kernel_matrix(kernel_, points_, smoothing_);
  progress.report("solve", 0.1);

  // Qᵀ A Q = A − V Yᵀ − Y Vᵀ with Y = A V T − ½ V (Tᵀ Vᵀ A V T).
  const Eigen::MatrixXd vt = reflectors_ * triangle_;
  Eigen::MatrixXd y = times_symmetric(factor_, vt);
  const Eigen::MatrixXd half_core = 0.5 * vt.transpose() * y;
  y -= reflectors_ * half_core;
  subtract_products(reflectors_, y, factor_);

  const Eigen::Index inner = factor_.cols() - rank;
  if (!cholesky_in_place(factor_.bottomRightCorner(inner, inner), progress))
    throw SolveError("dense solve", fmt::format("the system of {} constraints is singular", count),
                     "merge coinciding constraints or add smoothing");
}

Eigen::VectorXd DenseSolver::reflect_into_subspace(const Eigen::VectorXd& vector) const {
  return vector - reflectors_ * (triangle_.transpose() * (reflectors_.transpose() * vector));
}

Eigen::VectorXd DenseSolver::reflect_back(const Eigen::VectorXd& vector) const {
  return vector - reflectors_ * (triangle_ * (reflectors_.transpose() * vector));
}

Eigen::VectorXd DenseSolver::times_system(const Eigen::VectorXd& weights) const {
  Eigen::VectorXd product = direct_sum(kernel_, points_, weights, points_);
  if (smoothing_.size() > 0) product += kernel_.sign() * smoothing_.cwiseProduct(weights);
  return product;
}

RadialWeights DenseSolver::solve(const Eigen::VectorXd& values) const {
  const OneBlasThread one_thread;
  const Eigen::Index count = points_.cols();
  const int lda = static_cast<int>(count), inner = static_cast<int>(count - tail_rank()), one_column = 1;
  RadialWeights solution;
  solution.weights = Eigen::VectorXd::Zero(count);
  Eigen::VectorXd residual = values;
  for (int sweep = 0; sweep < 2; ++sweep) {  // the second sweep refines away rounding
    Eigen::VectorXd reflected = reflect_into_subspace(kernel_.sign() * residual);
    int info = 0;
    dpotrs_("L", &inner, &one_column, &factor_(tail_rank(), tail_rank()), &lda, &reflected[tail_rank()], &lda, &info);
    reflected.head(tail_rank()).setZero();
    solution.weights += reflect_back(reflected);
    residual = values - times_system(solution.weights);
  }
  solution.tail = tail_;
  solution.tail_coefficients = Eigen::VectorXd::Zero(tail_.size());
  solution.tail_coefficients(kept_) = tail_values_.householderQr().solve(residual);
  return solution;
}

}  // namespace isostack
