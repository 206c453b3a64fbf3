#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>

#include "recon/kernels/kernel.h"
#include "recon/solvers/radial_function.h"
#include "recon/solvers/radial_sums.h"

namespace isostack {

/// Σ_j weights_j φ(|x − c_j|) with fixed centres and weights, at any number of batches of points:
/// the sources are gathered once, and the far field of a place is kept once points came there, so
/// that a batch costs little more than its points' near terms. At most three dimensions. The
/// interpolation order is raised until a sample agrees with direct sums. How a point is summed depends on
/// its place alone, not on the batch, unless the batch is summed directly. May be used from several threads at once.
class FastField {
 public:
  struct Options {
    double tolerance = 1e-5;                ///< largest error of a value, in the values' units
    double reach = 1;                       ///< points may lie this far outside the centres' box, in its largest side
    std::size_t direct_pairs = 20'000'000;  ///< smaller batches (points · centres) are summed term by term
    std::size_t kept_bytes = std::size_t{1} << 30;  ///< of far fields kept from batch to batch
  };

  FastField(const Kernel& kernel, const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights,
            const Options& options);
  /// With the centres a fixed distance off in a further dimension.
  FastField(const RadialFunction& function, const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights,
            const Options& options);
  ~FastField();
  FastField(FastField&&) noexcept;
  FastField& operator=(FastField&&) noexcept;

  Eigen::VectorXd values(const Eigen::MatrixXd& points) const { return sums(points, Derivatives::none).values; }
  Eigen::MatrixXd gradients(const Eigen::MatrixXd& points) const { return sums(points, Derivatives::first).gradients; }
  /// Values and derivatives in one pass. Points are n × M.
  RadialSums sums(const Eigen::MatrixXd& points, Derivatives derivatives) const;

  /// Largest difference from direct sums in the sample the order was chosen by. Above the tolerance
  /// where rounding lets no order reach it: the best order is used then.
  double sampled_error() const;
  int order() const;  ///< interpolation nodes along an axis on the finest level

 private:
  struct Sources;
  struct Gathered;
  void choose_order();
  bool is_direct(const Eigen::MatrixXd& points) const;
  RadialSums fast_sums(Gathered& from, const Eigen::MatrixXd& points, Derivatives derivatives) const;

  std::unique_ptr<const Sources> sources_;
  std::unique_ptr<Gathered> gathered_;
};

}  // namespace isostack
