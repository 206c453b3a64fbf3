#pragma once

#include <utility>
#include <vector>

#include "segmentation/derivatives.h"
#include "segmentation/sparse_band.h"
#include "segmentation/speed_terms.h"

namespace isostack {

/// The weighted sum of all terms of an evolution. What is constant in time is asked once per node of the band.
template <int D>
class TermSum {
 public:
  explicit TermSum(const std::vector<WeightedTerm<D>>& terms) {
    for (const WeightedTerm<D>& term : terms) {
      (term.term->is_constant_in_time() ? constant_ : changing_).push_back(term);
      if (term.term->has_advection()) advecting_.push_back(term);
    }
  }

  void start(const Field<D>& phi) {
    for_each([&](SpeedTerm<D>& term) { term.start(phi); });
  }
  void prepare(const Field<D>& phi) {
    for_each([&](SpeedTerm<D>& term) { term.prepare(phi); });
  }
  void changed_side(std::size_t node, bool is_inside_now) {
    for (const auto& [term, weight] : changing_) term->changed_side(node, is_inside_now);
  }

  /// Propagation, and the weight of the curvature in mm.
  std::pair<double, double> speeds_at(BandNode& node) const {
    if (!node.is_asked) {
      const auto [propagation, weight_mm] = sum_of(constant_, node.node);
      node.propagation = static_cast<float>(propagation);
      node.curvature_weight_mm = static_cast<float>(weight_mm);
      node.is_asked = true;
    }
    const auto [propagation, weight_mm] = sum_of(changing_, node.node);
    return {propagation + node.propagation, weight_mm + node.curvature_weight_mm};
  }

  bool has_advection() const { return !advecting_.empty(); }

  /// A·∇φ with the differences taken from the side information comes from.
  double advection_at(std::size_t node, const Derivatives<D>& derivatives) const {
    double sum = 0;
    for (const auto& [term, weight] : advecting_) {
      const auto along = term->advection(node);
      for (int axis = 0; axis < D; ++axis)
        sum += weight * along[axis] * (along[axis] > 0 ? derivatives.forward : derivatives.backward)[axis];
    }
    return sum;
  }

 private:
  using Terms = std::vector<WeightedTerm<D>>;

  static std::pair<double, double> sum_of(const Terms& terms, std::size_t node) {
    double propagation = 0, weight_mm = 0;
    for (const auto& [term, weight] : terms) {
      propagation += weight * term->propagation(node);
      weight_mm += weight * term->curvature_weight_mm(node);
    }
    return {propagation, weight_mm};
  }

  template <class Call>
  void for_each(Call call) {
    for (const Terms* terms : {&constant_, &changing_})
      for (const auto& term : *terms) call(*term.term);
  }

  Terms constant_, changing_, advecting_;
};

}  // namespace isostack
