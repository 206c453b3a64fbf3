#pragma once

#include <cstddef>
#include <vector>

#include "segmentation/field.h"

namespace isostack {

/// One term of the speed F in φ_t = |∇φ| F, φ > 0 inside: F > 0 moves the curve outwards. F has no unit,
/// so that time is in mm: F = 1 moves the curve by t. A new term overrides what it contributes;
/// the sum of all propagation speeds is discretised upwind, all curvature weights centrally.
template <int D>
class SpeedTerm {
 public:
  virtual ~SpeedTerm() = default;
  /// Called before every step, for terms that depend on φ as a whole (for instance region means).
  virtual void prepare(const Field<D>& /*phi*/) {}
  /// Speed at a node, no unit.
  virtual double propagation(std::size_t /*node*/) const { return 0; }
  /// Factor of the mean curvature in mm, never negative.
  virtual double curvature_weight_mm(std::size_t /*node*/) const { return 0; }
};

/// F = β ∇·(∇φ/|∇φ|), Breen et al. 2001 eq. 10, β in mm: smooths; a disc of radius r shrinks by r² = r0² − 2βt.
template <int D>
class CurvatureTerm : public SpeedTerm<D> {
 public:
  explicit CurvatureTerm(double weight_mm) : weight_mm_(weight_mm) {}
  double curvature_weight_mm(std::size_t) const override { return weight_mm_; }

 private:
  double weight_mm_;
};

/// F = c everywhere: a balloon, or for ±1 the morphological propagator of Breen et al. 2001 eq. 9
/// (dilation and erosion by t mm).
template <int D>
class ConstantTerm : public SpeedTerm<D> {
 public:
  explicit ConstantTerm(double speed) : speed_(speed) {}
  double propagation(std::size_t) const override { return speed_; }

 private:
  double speed_;
};

/// F = g(α), α = (I − k)/(|∇I| w), g(α) = α/√(1 + α²), Breen et al. 2001 eq. 11: attracts to the curve I = k,
/// expanding where the image is brighter than k and shrinking where it is darker. (I − k)/|∇I| is the distance to
/// that curve to first order; w (the paper's unit, one pixel) is the distance at which the speed reaches 1/√2.
template <int D>
class IsosurfaceTerm : public SpeedTerm<D> {
 public:
  /// `image` lies on the lattice of φ. |∇I| (central differences) is kept above `gradient_floor` times its
  /// largest value, so that flat regions have a definite speed.
  IsosurfaceTerm(const Field<D>& image, double level, double width_mm, double gradient_floor = 0.01);
  double propagation(std::size_t node) const override { return speed_[node]; }

 private:
  std::vector<double> speed_;
};

extern template class IsosurfaceTerm<2>;
extern template class IsosurfaceTerm<3>;

}  // namespace isostack
