#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "recon/solvers/fast_sum.h"

namespace isostack {

/// Points of any dimension as layers: in one layer all coordinates beyond the third agree. In 3D
/// there is one layer; key frames of a 4D or 5D morph are a few.
struct PointLayers {
  struct Layer {
    std::vector<std::uint32_t> members;  ///< columns of the points
    Eigen::MatrixXd points;              ///< at most 3 × members
    Eigen::VectorXd place;               ///< the further coordinates
  };
  std::vector<Layer> layers;

  static constexpr std::size_t most_layers = 32;
  /// Gives up (no layers) when there would be more than `most_layers`.
  explicit PointLayers(const Eigen::MatrixXd& points);
};

/// The matrix φ(|c_i − c_j|) as an operator: fast sums between layers, or direct sums where there
/// are no layers or few points.
class KernelOperator {
 public:
  KernelOperator(const Kernel& kernel, const Eigen::MatrixXd& points, const FastSumOptions& options);

  Eigen::VectorXd times(const Eigen::VectorXd& weights);
  std::size_t bytes() const;

  /// Layers between which the sums are fast; 0 where every term is summed.
  static std::size_t layer_count(const Eigen::MatrixXd& points);

 private:
  Kernel kernel_;
  Eigen::MatrixXd points_;
  PointLayers layers_;
  std::vector<std::unique_ptr<FastSum>> sums_;  ///< [target layer · layers + source layer]
};

/// The same sums term by term at some of the points: (φ weights)[sample[k]].
Eigen::VectorXd direct_rows(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& weights,
                            const std::vector<std::uint32_t>& sample);

}  // namespace isostack
