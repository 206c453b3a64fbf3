#include "segmentation/level_set.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "recon/geometry/errors.h"
#include "segmentation/curve_distance.h"
#include "segmentation/derivatives.h"
#include "segmentation/fast_marching.h"
#include "segmentation/pieces.h"
#include "segmentation/sparse_band.h"
#include "segmentation/term_sum.h"

namespace isostack {

namespace {

template <int D>
void check(const Field<D>& phi) {
  for (const double h : phi.spacing_mm)
    if (!(h > 0) || !std::isfinite(h))
      throw InputError("level set", "the pixel spacing is not a positive number", "give the spacing in mm");
  if (!std::all_of(phi.values.begin(), phi.values.end(), [](float value) { return std::isfinite(value); }))
    throw InputError("level set", "the start has values that are not finite numbers", "repair the image it came from");
}

/// What a step needs to know of all nodes beside the curve.
struct Extremes {
  double speed = 0;             ///< of propagation and advection, no unit
  double slope = 0;             ///< |ΔF| per mm across the curve
  double curvature_weight = 0;  ///< mm
  double sum = 0;               ///< of F² on the curve
  double count = 0;
  bool is_finite = true;

  void add(const Extremes& other) {
    speed = std::max(speed, other.speed);
    slope = std::max(slope, other.slope);
    curvature_weight = std::max(curvature_weight, other.curvature_weight);
    sum += other.sum;
    count += other.count;
    is_finite = is_finite && other.is_finite;
  }
};

template <int D>
class Evolution {
 public:
  Evolution(Field<D> phi, const std::vector<WeightedTerm<D>>& terms, const LevelSetOptions& options)
      : options_(options),
        h_mm_(phi.smallest_spacing_mm()),
        result_{std::move(phi)},
        band_(result_.phi),
        terms_(terms) {
    for (double h : result_.phi.spacing_mm) inverse_h2_ += 1 / (h * h);
  }

  LevelSetResult<D> run(const Progress& progress, const LevelSetObserver<D>& observer) {
    terms_.start(result_.phi);
    result_.stop = LevelSetStop::max_steps;
    show(observer);
    while (!is_over()) {
      step();
      show(observer);
      progress.report("level set", static_cast<double>(result_.steps) / std::max(1, options_.max_steps));
    }
    finish();
    return std::move(result_);
  }

 private:
  /// True once there is a reason to stop, which is then in the result.
  bool is_over() {
    if (band_->layer(0).empty()) {
      const bool inside = !result_.phi.values.empty() && is_inside(result_.phi.values.front());
      result_.stop = inside ? LevelSetStop::flooded : LevelSetStop::vanished;
    }
    return result_.stop != LevelSetStop::max_steps || result_.steps >= options_.max_steps;
  }

  std::vector<std::size_t> beside_curve() {
    std::vector<std::size_t> nodes;
    for (const std::int32_t slot : band_->layer(0))
      nodes.push_back(band_->nodes()[static_cast<std::size_t>(slot)].node);
    return nodes;
  }

  void show(const LevelSetObserver<D>& observer) {
    if (observer && result_.stop != LevelSetStop::not_finite &&
        !observer({result_.phi, beside_curve(), result_.time_mm}))
      result_.stop = LevelSetStop::observed;
  }

  void finish() {
    const double band_mm = options_.band_pixels * h_mm_;
    if (options_.band_pixels <= narrow_band_pixels<D>) return band_->cut_off(band_mm);
    const std::vector<std::size_t> curve = beside_curve();
    band_.reset();
    redistance(result_.phi, band_mm, curve);
  }

  void step() {
    terms_.prepare(result_.phi);
    Extremes all = find_speeds();
    all.add(find_rates());
    if (!all.is_finite) {
      result_.stop = LevelSetStop::not_finite;
      return;
    }
    const double stiffness = std::max(all.speed / h_mm_, all.slope) + 2 * all.curvature_weight * inverse_h2_;
    const double stable_mm = stiffness > 0 ? options_.cfl / stiffness : h_mm_;
    const double time_left_mm = options_.max_time_mm - result_.time_mm;
    const double step_mm = std::min(stable_mm, time_left_mm);
    for (int layer = 1; layer < SparseBand<D>::outside; ++layer) carry_rates_to(layer);
    advance(step_mm);
    ++result_.steps;
    result_.time_mm += step_mm;
    result_.rms_change_pixels = std::sqrt(all.sum / all.count) * step_mm / h_mm_;
    if (time_left_mm <= stable_mm)
      result_.stop = LevelSetStop::max_time;
    else if (result_.rms_change_pixels < options_.tolerance_pixels)
      result_.stop = LevelSetStop::converged;
  }

  /// body(slot, extremes) for every node of a layer.
  template <class Body>
  Extremes for_each_in_layer(int layer, Body body) {
    const auto& slots = band_->layer(layer);
    const Pieces pieces{slots.size(), 1 << 13};
    std::vector<Extremes> found(pieces.number());
    pieces.for_each([&](std::size_t piece, std::size_t first, std::size_t last) {
      Extremes mine;
      for (std::size_t i = first; i < last; ++i) body(static_cast<std::size_t>(slots[i]), mine);
      found[piece] = mine;
    });
    Extremes all;
    for (const Extremes& one : found) all.add(one);
    return all;
  }

  /// F at the nodes beside the curve.
  Extremes find_speeds() {
    BandNode* const nodes = band_->nodes().data();
    float* const speeds = band_->speeds().data();
    return for_each_in_layer(0, [this, nodes, speeds](std::size_t slot, Extremes& extremes) {
      BandNode& node = nodes[slot];
      const auto [propagation, weight_mm] = terms_.speeds_at(node);
      double speed = propagation, fastest = std::abs(propagation);
      if (terms_.has_advection()) {
        const auto derivatives = derivatives_at(result_.phi, band_->lattice(), node.node, node.sides);
        const double carried = terms_.advection_at(node.node, derivatives);
        speed += carried;
        fastest += std::abs(carried);
      }
      if (weight_mm > 0) speed += weight_mm * curvature_motion(node);
      speeds[slot] = static_cast<float>(speed);
      extremes.speed = std::max(extremes.speed, fastest);
      extremes.curvature_weight = std::max(extremes.curvature_weight, weight_mm);
      extremes.is_finite = extremes.is_finite && std::isfinite(speed) && std::isfinite(weight_mm);
    });
  }

  /// Curvature times |∇φ|, 1/mm; a radius below a pixel cannot be represented.
  double curvature_motion(const BandNode& node) const {
    const auto& phi = result_.phi;
    const auto& lattice = band_->lattice();
    const double motion = node.sides == Lattice<D>::all_sides
                              ? curvature_motion_inside(phi.values.data() + node.node, lattice)
                              : derivatives_at(phi, lattice, node.node, node.sides).curvature_motion();
    return std::clamp(motion, -(D - 1) / h_mm_, (D - 1) / h_mm_);
  }

  /// φ_t at the nodes beside the curve: F at their closest point, which lies on the plane through the crossings on
  /// the axes. On the crossings F is interpolated between the two nodes.
  Extremes find_rates() {
    const BandNode* const nodes = band_->nodes().data();
    const float *const phi = result_.phi.values.data(), *const speeds = band_->speeds().data();
    float* const rates = band_->rates().data();
    const auto& lattice = band_->lattice();
    return for_each_in_layer(0, [=, &lattice, this](std::size_t slot, Extremes& extremes) {
      const BandNode& node = nodes[slot];
      const float value = phi[node.node], own = speeds[slot];
      float sum = 0, weights = 0;
      for (int axis = 0; axis < D; ++axis) {
        float nearest = 2, nearest_speed = 0;
        const auto look = [&](std::ptrdiff_t stride) {
          const std::size_t there = lattice.moved(node.node, stride);
          if (is_inside(phi[there]) == (value >= 0)) return;
          const float other = speeds[band_->slot_of(there)], share = value / (value - phi[there]);
          const float crossing_speed = own + share * (other - own);
          if (share < nearest) {
            nearest = share;
            nearest_speed = crossing_speed;
          }
          if (value < 0) return;
          const double difference = std::abs(static_cast<double>(other) - static_cast<double>(own));
          extremes.slope = std::max(extremes.slope, difference * lattice.inverse_spacing[axis]);
          extremes.sum += static_cast<double>(crossing_speed) * crossing_speed;
          ++extremes.count;
        };
        if (node.sides & lattice.before(axis)) look(-lattice.stride[axis]);
        if (node.sides & lattice.after(axis)) look(lattice.stride[axis]);
        if (nearest > 1) continue;
        const auto inverse = static_cast<float>(lattice.inverse_spacing[axis]) / std::max(nearest, 1e-6f);
        sum += inverse * inverse * nearest_speed;
        weights += inverse * inverse;
      }
      rates[slot] = sum / weights;
    });
  }

  void carry_rates_to(int layer) {
    SparseBand<D>& band = *band_;
    float* const rates = band.rates().data();
    for_each_in_layer(layer, [&band, rates](std::size_t slot, Extremes&) { rates[slot] = band.rate_from_inner(slot); });
  }

  void advance(double step_mm) {
    std::vector<std::size_t> changed;
    std::vector<std::int32_t> travelled;
    move_phi(step_mm, changed, travelled);
    for (const std::size_t node : changed) terms_.changed_side(node, is_inside(result_.phi.values[node]));
    if (!changed.empty()) band_->follow(changed);
    band_->renew(travelled, h_mm_);
  }

  /// Lists the nodes that change their side, and where in the band φ has moved by a pixel.
  void move_phi(double step_mm, std::vector<std::size_t>& changed, std::vector<std::int32_t>& travelled) {
    float* const phi = result_.phi.values.data();
    auto& nodes = band_->nodes();
    const float *const rates = band_->rates().data(), step = static_cast<float>(step_mm);
    const auto limit = static_cast<float>(h_mm_), per_quarter_pixel = static_cast<float>(4 / h_mm_);
    const Pieces pieces{nodes.size(), 1 << 15};
    std::vector<std::vector<std::size_t>> changed_in(pieces.number());
    std::vector<std::vector<std::int32_t>> travelled_in(pieces.number());
    pieces.for_each([&](std::size_t piece, std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        BandNode& node = nodes[i];
        if (node.layer == SparseBand<D>::outside) continue;
        float& value = phi[node.node];
        const float change = step * rates[i], moved = node.moved_mm + std::abs(change);
        const bool was_inside = is_inside(value);
        value += change;
        if (is_inside(value) != was_inside) changed_in[piece].push_back(node.node);
        // The direction to the curve may have turned.
        if (static_cast<int>(moved * per_quarter_pixel) != static_cast<int>(node.moved_mm * per_quarter_pixel))
          node.has_sources = false;
        if (moved > limit) travelled_in[piece].push_back(static_cast<std::int32_t>(i));
        node.moved_mm = moved;
      }
    });
    for (const auto& part : changed_in) changed.insert(changed.end(), part.begin(), part.end());
    for (const auto& part : travelled_in) travelled.insert(travelled.end(), part.begin(), part.end());
  }

  const LevelSetOptions& options_;
  const double h_mm_;
  double inverse_h2_ = 0;  ///< Σ 1/h²
  LevelSetResult<D> result_;
  std::optional<SparseBand<D>> band_;
  TermSum<D> terms_;
};

}  // namespace

template <int D>
LevelSetResult<D> evolve(Field<D> phi, const std::vector<WeightedTerm<D>>& terms, const LevelSetOptions& options,
                         const Progress& progress, const LevelSetObserver<D>& observer) {
  check(phi);
  return Evolution<D>(std::move(phi), terms, options).run(progress, observer);
}

template LevelSetResult<2> evolve(Field<2>, const std::vector<WeightedTerm<2>>&, const LevelSetOptions&,
                                  const Progress&, const LevelSetObserver<2>&);
template LevelSetResult<3> evolve(Field<3>, const std::vector<WeightedTerm<3>>&, const LevelSetOptions&,
                                  const Progress&, const LevelSetObserver<3>&);

}  // namespace isostack
