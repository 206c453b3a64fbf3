#pragma once

#include <string>
#include <string_view>

namespace isostack {

/// A radial kernel φ(r) = r^power, or r^power · log r, with the polynomial tail it needs
/// (Turk & O'Brien 1999, eq. 2; Duchon 1977).
///
/// sign · φ is conditionally positive definite: for distinct points and weights that annihilate
/// every polynomial of degree tail_degree, sign · wᵀφw > 0.
struct Kernel {
  int power = 3;
  bool logarithmic = false;
  int tail_degree = 1;

  int sign() const;
  /// φ as a function of the squared distance; 0 at 0.
  double value(double squared_distance) const;
  /// φ'(r)/r, the factor that turns the offset vector into the gradient; 0 at 0.
  double slope_over_distance(double squared_distance) const;
  /// d/dr(φ'(r)/r)/r: with `slope_over_distance` it gives the Hessian
  /// s·I + c·d·dᵀ at offset d; 0 at 0.
  double curvature_factor(double squared_distance) const;
  std::string name() const;
};

Kernel biharmonic();   ///< r
Kernel thin_plate();   ///< r² log r
Kernel triharmonic();  ///< r³

/// Duchon's minimiser of ∫|Dᵐf|² in n dimensions. Throws InputError unless 2m > n.
Kernel duchon(int dimension, int order);

/// By the names above ("biharmonic", "thin_plate", "triharmonic"). Throws InputError on others.
Kernel kernel_named(std::string_view name);

}  // namespace isostack
