#include "recon/solvers/tail_space.h"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace isostack {

namespace {

constexpr Eigen::Index chunk = 4096;

/// Sums chunk results in a fixed order.
template <class Result, class OfChunk>
Result sum_chunks(Eigen::Index count, const Result& zero, OfChunk of_chunk) {
  std::vector<Result> parts(static_cast<std::size_t>((count + chunk - 1) / chunk), zero);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t k) {
    const Eigen::Index begin = static_cast<Eigen::Index>(k) * chunk;
    parts[k] = of_chunk(begin, std::min(chunk, count - begin));
  });
  Result sum = zero;
  for (const Result& part : parts) sum += part;
  return sum;
}

template <class Apply>
void for_chunks(Eigen::Index count, Apply apply) {
  tbb::parallel_for(Eigen::Index{0}, (count + chunk - 1) / chunk,
                    [&](Eigen::Index k) { apply(k * chunk, std::min(chunk, count - k * chunk)); });
}

Eigen::MatrixXd gram(const Eigen::MatrixXd& values) {
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(values.cols(), values.cols());
  return sum_chunks(values.rows(), zero, [&](Eigen::Index begin, Eigen::Index count) -> Eigen::MatrixXd {
    const auto rows = values.middleRows(begin, count);
    return rows.transpose() * rows;
  });
}

}  // namespace

double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return sum_chunks(a.size(), 0.0, [&](Eigen::Index begin, Eigen::Index count) {
    return a.segment(begin, count).dot(b.segment(begin, count));
  });
}

TailSpace::TailSpace(const PolynomialBasis& basis, const Eigen::MatrixXd& points) {
  values_.resize(points.cols(), basis.size());
  for_chunks(points.cols(), [&](Eigen::Index begin, Eigen::Index count) {
    values_.middleRows(begin, count) = basis.values(points.middleCols(begin, count));
  });
  coefficients_ = Eigen::MatrixXd::Identity(basis.size(), basis.size());
  for (int pass = 0; pass < 2; ++pass) {  // the second one makes up for the first one's rounding
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram(values_));
    const double largest = eigen.eigenvalues().maxCoeff();
    const auto rank = (eigen.eigenvalues().array() > 1e-14 * largest).count();
    const Eigen::MatrixXd change =
        eigen.eigenvectors().rightCols(rank) * eigen.eigenvalues().tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
    Eigen::MatrixXd next(values_.rows(), rank);
    for_chunks(values_.rows(), [&](Eigen::Index begin, Eigen::Index count) {
      next.middleRows(begin, count).noalias() = values_.middleRows(begin, count) * change;
    });
    values_ = std::move(next);
    coefficients_ = coefficients_ * change;
  }
}

Eigen::VectorXd TailSpace::remove_from(Eigen::VectorXd& values) const {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(rank());
  const Eigen::VectorXd parts =
      sum_chunks(values.size(), zero, [&](Eigen::Index begin, Eigen::Index count) -> Eigen::VectorXd {
        return values_.middleRows(begin, count).transpose() * values.segment(begin, count);
      });
  for_chunks(values.size(), [&](Eigen::Index begin, Eigen::Index count) {
    values.segment(begin, count).noalias() -= values_.middleRows(begin, count) * parts;
  });
  return coefficients_ * parts;
}

std::vector<std::uint32_t> TailSpace::determining_points() const {
  Eigen::MatrixXd left = values_;
  std::vector<std::uint32_t> points;
  for (Eigen::Index k = 0; k < rank(); ++k) {
    Eigen::Index best = 0;
    left.rowwise().squaredNorm().maxCoeff(&best);
    points.push_back(static_cast<std::uint32_t>(best));
    const Eigen::VectorXd direction = left.row(best).transpose().normalized();
    const Eigen::VectorXd along = left * direction;
    left.noalias() -= along * direction.transpose();
  }
  return points;
}

}  // namespace isostack
