#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "segmentation/field.h"

namespace isostack {

/// One term of the speed F in φ_t = |∇φ| F, φ > 0 inside: F > 0 moves the curve outwards. F has no unit,
/// so that time is in mm: F = 1 moves the curve by t. A new term overrides what it contributes:
/// F = propagation + advection·∇φ/|∇φ| + curvature_weight_mm ∇·(∇φ/|∇φ|).
/// A term is asked at the nodes next to the curve only, from several threads at once.
template <int D>
class SpeedTerm {
 public:
  using Vector = Eigen::Matrix<double, D, 1>;

  virtual ~SpeedTerm() = default;
  /// True when no value below depends on φ: each node is then asked once while the curve is near.
  virtual bool is_constant_in_time() const { return false; }
  /// Called once before the first step, for terms that depend on φ as a whole. φ is a signed distance in mm within two
  /// nodes of the curve; farther away only its sign tells. It stays in place until the evolution ends.
  virtual void start(const Field<D>& /*phi*/) {}
  /// Called before every step.
  virtual void prepare(const Field<D>& /*phi*/) {}
  /// Called between two steps for every node that changed its side, so that sums over the regions can follow.
  virtual void changed_side(std::size_t /*node*/, bool /*is_inside_now*/) {}
  /// Speed at a node, no unit.
  virtual double propagation(std::size_t /*node*/) const { return 0; }
  /// Factor of the mean curvature in mm, never negative.
  virtual double curvature_weight_mm(std::size_t /*node*/) const { return 0; }
  /// A in F = A·∇φ/|∇φ|, no unit: the curve is carried along −A. Asked only where has_advection().
  virtual Vector advection(std::size_t /*node*/) const { return Vector::Zero(); }
  virtual bool has_advection() const { return false; }
};

/// A term and its weight in the sum, ≥ 0.
template <int D>
struct WeightedTerm {
  WeightedTerm(SpeedTerm<D>* a_term, double a_weight = 1) : term(a_term), weight(a_weight) {}
  SpeedTerm<D>* term;
  double weight;
};

/// F = β ∇·(∇φ/|∇φ|), Breen et al. 2001 eq. 10, β in mm: smooths; a disc of radius r shrinks by r² = r0² − 2βt, a ball
/// by r² = r0² − 4βt.
template <int D>
class CurvatureTerm : public SpeedTerm<D> {
 public:
  explicit CurvatureTerm(double weight_mm) : weight_mm_(weight_mm) {}
  bool is_constant_in_time() const override { return true; }
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
  bool is_constant_in_time() const override { return true; }
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
  IsosurfaceTerm(SharedField<D> image, double level, double width_mm, double gradient_floor = 0.01);
  bool is_constant_in_time() const override { return true; }
  double propagation(std::size_t node) const override;

 private:
  SharedField<D> image_;
  double level_, width_mm_, least_slope_;
};

/// F = min(I − lower, upper − I)/scale, within [−1, 1]: expands where lower < I < upper and shrinks elsewhere, faster
/// the farther I is from the nearer limit (the speed of ITK's threshold segmentation, divided by `scale`).
template <int D>
class ThresholdRangeTerm : public SpeedTerm<D> {
 public:
  /// `image` lies on the lattice of φ; `scale` in its grey values, 0: half the range, so that F = 1 in its middle.
  /// Throws InputError unless lower < upper, both finite, and scale >= 0.
  ThresholdRangeTerm(SharedField<D> image, double lower, double upper, double scale = 0);
  bool is_constant_in_time() const override { return true; }
  double propagation(std::size_t node) const override;

 private:
  SharedField<D> image_;
  double lower_, upper_, scale_;
};

extern template class IsosurfaceTerm<2>;
extern template class IsosurfaceTerm<3>;
extern template class ThresholdRangeTerm<2>;
extern template class ThresholdRangeTerm<3>;

}  // namespace isostack
