#include "segmentation/level_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "segmentation/derivatives.h"
#include "segmentation/fast_marching.h"

namespace isostack {

namespace {

template <int D>
class Evolution {
 public:
  Evolution(Field<D> phi, const std::vector<SpeedTerm<D>*>& terms, const LevelSetOptions& options)
      : terms_(terms),
        options_(options),
        h_mm_(phi.smallest_spacing_mm()),
        speed_(phi.values.size(), 0.0),
        rate_(phi.values.size(), 0.0) {
    result_.phi = std::move(phi);
    for (double h : result_.phi.spacing_mm) inverse_h2_ += 1 / (h * h);
  }

  LevelSetResult<D> run() {
    rebuild_band();
    result_.stop = LevelSetStop::max_steps;
    while (result_.steps < options_.max_steps && result_.stop == LevelSetStop::max_steps) step();
    rebuild_band();
    return std::move(result_);
  }

 private:
  void rebuild_band() {
    redistance(result_.phi, (options_.band_pixels + 2) * h_mm_);
    for (std::size_t node : band_) rate_[node] = speed_[node] = 0;
    band_.clear();
    for (std::size_t node = 0; node < result_.phi.values.size(); ++node)
      if (std::abs(result_.phi.values[node]) < options_.band_pixels * h_mm_) band_.push_back(node);
    largest_change_mm_ = 0;
  }

  void step() {
    const double time_left_mm = options_.max_time_mm - result_.time_mm;
    const double stable_mm = compute_rates();
    const double step_mm = std::min(stable_mm, time_left_mm);
    const double speed = curve_speed();
    if (std::isnan(speed)) {
      result_.stop = LevelSetStop::no_curve;
      return;
    }
    double change_mm = 0;
    for (std::size_t node : band_) {
      result_.phi.values[node] += step_mm * rate_[node];
      change_mm = std::max(change_mm, std::abs(step_mm * rate_[node]));
    }
    ++result_.steps;
    result_.time_mm += step_mm;
    result_.rms_change_pixels = speed * step_mm / h_mm_;
    largest_change_mm_ += change_mm;
    if (time_left_mm <= stable_mm)
      result_.stop = LevelSetStop::max_time;
    else if (result_.rms_change_pixels < options_.tolerance_pixels)
      result_.stop = LevelSetStop::converged;
    else if (largest_change_mm_ > h_mm_)
      rebuild_band();
  }

  /// φ_t at every node of the band; returns the time step that keeps the explicit scheme stable.
  double compute_rates() {
    for (SpeedTerm<D>* term : terms_) term->prepare(result_.phi);
    // The fastest of the whole band, also when the curve itself rests: a speed that rises to it within a pixel
    // would make larger steps overshoot.
    double fastest = 0;
    for (std::size_t node : band_) {
      speed_[node] = 0;
      for (const SpeedTerm<D>* term : terms_) speed_[node] += term->propagation(node);
      fastest = std::max(fastest, std::abs(speed_[node]));
    }
    double heaviest_mm = 0;
    for (std::size_t node : band_) {
      const Derivatives<D> derivatives = derivatives_at(result_.phi, node);
      const double speed = speed_at_closest_point(node, derivatives.gradient());
      rate_[node] = speed * derivatives.upwind_gradient_norm(speed > 0);
      double weight_mm = 0;
      for (const SpeedTerm<D>* term : terms_) weight_mm += term->curvature_weight_mm(node);
      if (weight_mm > 0) {
        // A radius below a pixel cannot be represented.
        const double bound = (D - 1) / h_mm_;
        rate_[node] +=
            weight_mm * std::clamp(derivatives.mean_curvature(), -bound, bound) * derivatives.gradient().norm();
      }
      heaviest_mm = std::max(heaviest_mm, weight_mm);
    }
    const double stiffness = fastest * std::sqrt(inverse_h2_) + 2 * heaviest_mm * inverse_h2_;
    return stiffness > 0 ? options_.cfl / stiffness : h_mm_;
  }

  /// The curve's speed, carried along its normal to the node (Adalsteinsson and Sethian 1999): φ stays a distance,
  /// and rests where the curve rests. Multilinear between the nodes around the closest point.
  double speed_at_closest_point(std::size_t node, const typename Derivatives<D>::Vector& gradient) const {
    const auto& phi = result_.phi;
    const double norm = gradient.norm();
    if (!(norm > 0)) return speed_[node];
    auto corner = phi.position_of(node);
    std::array<double, D> fraction;
    for (int axis = 0; axis < D; ++axis) {
      const double offset_mm = -phi.values[node] * gradient[axis] / norm;
      const double last = phi.size[axis] - 1;
      const double position = std::clamp(corner[axis] + offset_mm / phi.spacing_mm[axis], 0.0, last);
      corner[axis] = std::clamp(static_cast<int>(position), 0, std::max(0, phi.size[axis] - 2));
      fraction[axis] = position - corner[axis];
    }
    double speed = 0;
    for (unsigned bits = 0; bits < 1u << D; ++bits) {
      double weight = 1;
      auto at = corner;
      for (int axis = 0; axis < D; ++axis) {
        const bool upper = (bits >> axis & 1u) != 0 && phi.size[axis] > 1;
        weight *= bits >> axis & 1u ? fraction[axis] : 1 - fraction[axis];
        at[axis] += upper;
      }
      speed += weight * speed_[phi.node_at(at)];
    }
    return speed;
  }

  /// RMS of φ_t on the zero set, interpolated to its crossings with the lattice lines: the nodes beside it keep
  /// moving towards it when it rests. NaN when there is none.
  double curve_speed() const {
    const auto& phi = result_.phi;
    double sum = 0;
    int count = 0;
    for (std::size_t node : band_) {
      const auto position = phi.position_of(node);
      for (int axis = 0; axis < D; ++axis) {
        if (position[axis] + 1 >= phi.size[axis]) continue;
        const std::size_t next = node + phi.stride(axis);
        const double a = phi.values[node], b = phi.values[next];
        if ((a >= 0) == (b >= 0)) continue;
        const double t = a / (a - b);
        sum += std::pow((1 - t) * rate_[node] + t * rate_[next], 2);
        ++count;
      }
    }
    return count > 0 ? std::sqrt(sum / count) : std::numeric_limits<double>::quiet_NaN();
  }

  const std::vector<SpeedTerm<D>*>& terms_;
  const LevelSetOptions& options_;
  const double h_mm_;
  double inverse_h2_ = 0;  ///< Σ 1/h²
  std::vector<std::size_t> band_;
  std::vector<double> speed_;     ///< propagation of all terms, 0 outside the band
  std::vector<double> rate_;      ///< φ_t, 0 outside the band
  double largest_change_mm_ = 0;  ///< sum over the steps since φ was last a distance
  LevelSetResult<D> result_;
};

}  // namespace

template <int D>
LevelSetResult<D> evolve(Field<D> phi, const std::vector<SpeedTerm<D>*>& terms, const LevelSetOptions& options) {
  return Evolution<D>(std::move(phi), terms, options).run();
}

template LevelSetResult<2> evolve(Field<2>, const std::vector<SpeedTerm<2>*>&, const LevelSetOptions&);
template LevelSetResult<3> evolve(Field<3>, const std::vector<SpeedTerm<3>*>&, const LevelSetOptions&);

}  // namespace isostack
