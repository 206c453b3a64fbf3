#pragma once

#include <Eigen/Core>
#include <memory>

#include "recon/kernels/kernel.h"
#include "recon/solvers/leaf_sums.h"

namespace isostack {

/// Σ_j weights_j φ(|x − c_j|) with fixed centres and weights, at any number of batches of points:
/// the sources are gathered once, each batch costs little more than its points. At most three
/// dimensions. The interpolation order is raised until a sample agrees with direct sums.
class FastField {
 public:
  struct Options {
    double tolerance = 1e-5;                ///< largest error of a value, in the values' units
    double reach = 1;                       ///< points may lie this far outside the centres' box, in its largest side
    std::size_t direct_pairs = 20'000'000;  ///< smaller batches (points · centres) are summed term by term
  };

  FastField(const Kernel& kernel, const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights,
            const Options& options);
  ~FastField();
  FastField(FastField&&) noexcept;
  FastField& operator=(FastField&&) noexcept;

  Eigen::VectorXd values(const Eigen::MatrixXd& points) const;
  Eigen::MatrixXd gradients(const Eigen::MatrixXd& points) const;

  /// Largest difference from direct sums in the sample the order was chosen by.
  double sampled_error() const;

 private:
  struct Sources;
  bool is_direct(const Eigen::MatrixXd& points) const;
  RadialSums sums(const Eigen::MatrixXd& points, Derivatives derivatives) const;

  std::unique_ptr<Sources> sources_;
};

}  // namespace isostack
