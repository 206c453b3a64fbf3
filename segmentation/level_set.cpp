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

  LevelSetResult<D> run() {
    terms_.start(result_.phi);
    result_.stop = LevelSetStop::max_steps;
    while (!is_over()) step();
    std::vector<std::size_t> beside_curve;
    for (const std::int32_t slot : band_->layer(0))
      beside_curve.push_back(band_->nodes()[static_cast<std::size_t>(slot)].node);
    band_.reset();
    redistance(result_.phi, options_.band_pixels * h_mm_, beside_curve);
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

  /// body(node, extremes) for every node of a layer.
  template <class Body>
  Extremes for_each_in_layer(int layer, Body body) {
    const auto& slots = band_->layer(layer);
    auto& nodes = band_->nodes();
    const Pieces pieces{slots.size(), 1 << 13};
    std::vector<Extremes> found(pieces.number());
    pieces.for_each([&](std::size_t piece, std::size_t first, std::size_t last) {
      Extremes mine;
      for (std::size_t i = first; i < last; ++i) body(nodes[static_cast<std::size_t>(slots[i])], mine);
      found[piece] = mine;
    });
    Extremes all;
    for (const Extremes& one : found) all.add(one);
    return all;
  }

  /// F at the nodes beside the curve.
  Extremes find_speeds() {
    return for_each_in_layer(0, [&](BandNode& node, Extremes& extremes) {
      const auto [propagation, weight_mm] = terms_.speeds_at(node);
      double speed = propagation, fastest = std::abs(propagation);
      if (terms_.has_advection()) {
        const auto derivatives = derivatives_at(result_.phi, band_->lattice(), node.node, node.sides);
        const double carried = terms_.advection_at(node.node, derivatives);
        speed += carried;
        fastest += std::abs(carried);
      }
      if (weight_mm > 0) speed += weight_mm * curvature_motion(node);
      node.speed = static_cast<float>(speed);
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
    const auto& phi = result_.phi.values;
    const auto& lattice = band_->lattice();
    return for_each_in_layer(0, [&](BandNode& node, Extremes& extremes) {
      const double value = phi[node.node];
      double sum = 0, weights = 0, nearest = -1, nearest_speed = 0;
      const auto leave_axis = [&] {
        if (nearest < 0) return;
        const double weight = 1 / (nearest * nearest);
        sum += weight * nearest_speed;
        weights += weight;
        nearest = -1;
      };
      int last_axis = -1;
      lattice.for_each_neighbour(node.sides, [&](int axis, std::ptrdiff_t stride) {
        if (axis != last_axis) leave_axis();
        last_axis = axis;
        const std::size_t there = lattice.moved(node.node, stride);
        if (is_inside(phi[there]) == (value >= 0)) return;
        const double h = lattice.spacing_mm[axis], other = band_->at(there).speed;
        const double share = value / (value - static_cast<double>(phi[there]));
        const double crossing_speed = (1 - share) * node.speed + share * other;
        const double distance = std::max(share, 1e-6) * h;
        if (nearest < 0 || distance < nearest) {
          nearest = distance;
          nearest_speed = crossing_speed;
        }
        if (value < 0) return;
        extremes.slope = std::max(extremes.slope, std::abs(other - static_cast<double>(node.speed)) / h);
        extremes.sum += crossing_speed * crossing_speed;
        ++extremes.count;
      });
      leave_axis();
      node.rate = static_cast<float>(sum / weights);
    });
  }

  /// ∇φ_t·∇φ = 0, upwind: from the neighbours of inner layers.
  void carry_rates_to(int layer) {
    const auto& phi = result_.phi.values;
    const auto& lattice = band_->lattice();
    for_each_in_layer(layer, [&](BandNode& node, Extremes&) {
      const double own = std::abs(phi[node.node]);
      double sum = 0, weights = 0, any = 0;
      lattice.for_each_neighbour(node.sides, [&](int axis, std::ptrdiff_t stride) {
        const std::size_t there = lattice.moved(node.node, stride);
        if (!band_->has(there)) return;
        const BandNode& inner = band_->at(there);
        if (inner.layer >= layer) return;
        const double h = lattice.spacing_mm[axis];
        const double weight = std::max(0.0, own - std::abs(static_cast<double>(phi[there]))) / (h * h);
        sum += weight * inner.rate;
        weights += weight;
        any = inner.rate;
      });
      node.rate = static_cast<float>(weights > 0 ? sum / weights : any);
    });
  }

  void advance(double step_mm) {
    auto& phi = result_.phi.values;
    auto& nodes = band_->nodes();
    const Pieces pieces{nodes.size(), 1 << 15};
    std::vector<std::vector<std::size_t>> changed_in(pieces.number());
    pieces.for_each([&](std::size_t piece, std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        BandNode& node = nodes[i];
        if (node.layer == SparseBand<D>::outside) continue;
        float& value = phi[node.node];
        const auto change = static_cast<float>(step_mm * node.rate);
        const bool was_inside = is_inside(value);
        value += change;
        node.moved_mm += std::abs(change);
        if (is_inside(value) != was_inside) changed_in[piece].push_back(node.node);
      }
    });
    std::vector<std::size_t> changed;
    for (const auto& part : changed_in) changed.insert(changed.end(), part.begin(), part.end());
    for (const std::size_t node : changed) terms_.changed_side(node, is_inside(phi[node]));
    if (!changed.empty()) band_->follow(changed);
    band_->renew(h_mm_);
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
LevelSetResult<D> evolve(Field<D> phi, const std::vector<WeightedTerm<D>>& terms, const LevelSetOptions& options) {
  check(phi);
  return Evolution<D>(std::move(phi), terms, options).run();
}

template LevelSetResult<2> evolve(Field<2>, const std::vector<WeightedTerm<2>>&, const LevelSetOptions&);
template LevelSetResult<3> evolve(Field<3>, const std::vector<WeightedTerm<3>>&, const LevelSetOptions&);

}  // namespace isostack
