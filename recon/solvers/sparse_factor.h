#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/kernels/kernel.h"
#include "recon/solvers/coarse_to_fine.h"

namespace isostack {

/// A sparse matrix U with U Uᵀ ≈ the inverse of sign · φ (plus smoothing) on the vectors that
/// annihilate the tail's polynomials: the preconditioner of the fast solver. Its columns
/// annihilate the polynomials, so U Uᵀ r does.
class SparseFactor {
 public:
  /// `points` (n × N) are distinct and in an order along a space-filling curve. `smoothing` is empty or one
  /// ρ ≥ 0 per point. `first` are points on which the tail's polynomials are determined.
  SparseFactor(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& smoothing,
               const std::vector<std::uint32_t>& first, const CoarseToFineOptions& options,
               const Progress& progress = {});

  /// U Uᵀ r.
  Eigen::VectorXd apply(const Eigen::VectorXd& residual) const;

  std::size_t entry_count() const { return indices_.size(); }
  std::size_t bytes() const;
  /// Columns whose nearest predecessors did not determine the polynomials, or had no definite system.
  std::size_t repaired_count() const { return repaired_; }

  double order_seconds = 0, factor_seconds = 0;

 private:
  void fill_level(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& smoothing,
                  const std::vector<std::uint32_t>& first, const CoarseToFine::Level& level);
  Eigen::VectorXd transposed_times(const Eigen::VectorXd& residual) const;
  Eigen::VectorXd times(const Eigen::VectorXd& v) const;

  /// Columns of U: entries begin_[i] … begin_[i + 1] belong to point i.
  std::vector<std::uint64_t> begin_;
  std::vector<std::uint32_t> indices_;
  std::vector<double> values_;
  std::size_t repaired_ = 0;
};

}  // namespace isostack
