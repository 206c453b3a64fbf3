#pragma once

#include <Eigen/Core>
#include <memory>

#include "recon/kernels/kernel.h"
#include "recon/solvers/radial_weights.h"
#include "recon/surface/scalar_field.h"

namespace isostack {

/// f(x) = Σ_j w_j φ(|x − c_j|) + p(x) in n ≥ 3 dimensions, evaluated in three-dimensional sections: the first three
/// coordinates vary, the others are fixed (Turk & O'Brien 1999, §5.2, §7). The centres lie in few layers of equal
/// further coordinates, as the key shapes of a morph do; in a section every layer is a sum over 3D points with the
/// kernel φ(√(r² + d²)), d being the layer's fixed distance from the section.
class LayeredFunction {
 public:
  /// Centres are n × N in the order of solution.weights. Throws InputError when n < 3 or they lie in more than 32
  /// layers.
  LayeredFunction(const Kernel& kernel, const Eigen::MatrixXd& centres, const RadialWeights& solution);

  Eigen::Index dimension() const;

  /// The function at fixed further coordinates (n − 3 of them), to `tolerance` in the values' units. It keeps alive
  /// what it needs. Layers of many centres are summed fast, within
  /// the largest side of the box round all centres outside of it; making the section prepares that.
  ScalarField section(const Eigen::VectorXd& place, double tolerance = 1e-5) const;

 private:
  struct Layers;
  std::shared_ptr<const Layers> layers_;
};

}  // namespace isostack
