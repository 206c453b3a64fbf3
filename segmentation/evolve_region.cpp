#include "segmentation/evolve_region.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "recon/geometry/errors.h"
#include "segmentation/derivatives.h"
#include "segmentation/edge_term.h"
#include "segmentation/fast_marching.h"
#include "segmentation/level_set.h"
#include "segmentation/region_term.h"
#include "segmentation/speed_terms.h"

namespace isostack {

namespace {

template <int D>
double share_inside(const Field<D>& phi) {
  const auto inside = std::count_if(phi.values.begin(), phi.values.end(), [](float value) { return value >= 0; });
  return static_cast<double>(inside) / static_cast<double>(std::max<std::size_t>(1, phi.values.size()));
}

/// The start in a bit per node, to judge by when the result is nothing.
template <int D>
struct Footprint {
  std::vector<bool> inside;
  double share = 0;

  explicit Footprint(const Field<D>& phi) : share(share_inside(phi)) {
    for (const float value : phi.values) inside.push_back(value >= 0);
  }
  /// Whether it holds a ball of this radius.
  bool is_deeper_than(double radius_mm, Field<D> like) const {
    std::copy(inside.begin(), inside.end(), like.values.begin());
    for (float& value : like.values) value -= 0.5f;
    redistance(like, radius_mm + like.smallest_spacing_mm());
    return *std::max_element(like.values.begin(), like.values.end()) > radius_mm;
  }
};

template <int D>
void require_sound(const Footprint<D>& start, const Field<D>& result, const EvolutionOptions& options,
                   const std::string& where) {
  const double share = share_inside(result);
  // Less deep parts may vanish without a word: the curvature takes them, or they are noise.
  const double least_mm = (3 + 3 * options.curvature) * result.smallest_spacing_mm();
  if (share == 0 && start.is_deeper_than(least_mm, result))
    throw InputError(where, "the evolution makes the organ vanish",
                     "try a smaller --curvature, or a level or range that leaves more of it");
  if (share > 0.98 && start.share < 0.5)
    throw InputError(where, "the evolution floods the whole frame",
                     "try a level or range that takes less, a larger --curvature, or --stay");
}

/// Owns the terms of one evolution.
template <int D>
struct Terms {
  std::vector<std::unique_ptr<SpeedTerm<D>>> owned;
  std::vector<WeightedTerm<D>> weighted;

  void add(std::unique_ptr<SpeedTerm<D>> term, double weight) {
    weighted.emplace_back(term.get(), weight);
    owned.push_back(std::move(term));
  }
};

template <int D>
Field<D> depth_field(const Field<D>& grey, const GreyRange& range) {
  Field<D> depth = grey;
  for (float& value : depth.values) value = static_cast<float>(range.depth(value));
  return depth;
}

template <int D>
double rms_slope(const Field<D>& grey) {
  double sum = 0;
  for (std::size_t node = 0; node < grey.values.size(); ++node)
    sum += derivatives_at(grey, node).gradient().squaredNorm();
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, grey.values.size())));
}

template <int D>
Terms<D> terms_of(const Field<D>& grey, const std::optional<GreyRange>& range, const EvolutionOptions& options) {
  const double pixel_mm = grey.smallest_spacing_mm();
  Terms<D> terms;
  if (options.curvature > 0) terms.add(std::make_unique<CurvatureTerm<D>>(options.curvature * pixel_mm), 1);
  const bool is_replaced = options.region > 0 || options.edge > 0;
  const double range_weight = options.range_weight.value_or(is_replaced ? 0 : 1);
  if (range && range_weight > 0)
    terms.add(std::make_unique<IsosurfaceTerm<D>>(depth_field(grey, *range), 0, pixel_mm), range_weight);
  if (options.region <= 0 && options.edge <= 0) {
    if (options.balloon != 0) terms.add(std::make_unique<ConstantTerm<D>>(options.balloon), 1);
    return terms;
  }
  const SharedField<D> shared(grey);
  if (options.region > 0)
    terms.add(std::make_unique<RegionTerm<D>>(shared, RegionOptions{.window_mm = options.region_window_mm}),
              options.region);
  EdgeOptions edge{.contrast = options.edge_contrast, .length_mm = options.edge * pixel_mm, .balloon = options.balloon};
  if (edge.contrast == 0) edge.contrast = std::max(2 * rms_slope(grey), 1e-30);
  if (options.edge > 0)
    terms.add(std::make_unique<EdgeTerm<D>>(shared, edge), 1);
  else if (options.balloon != 0)
    terms.add(std::make_unique<ConstantTerm<D>>(options.balloon), 1);
  return terms;
}

}  // namespace

template <int D>
Field<D> evolve_region(Field<D> start, const Field<D>& grey, const std::optional<GreyRange>& range,
                       const EvolutionOptions& options, const std::string& where, const Progress& progress,
                       const LevelSetObserver<D>& observer) {
  const double pixel_mm = start.smallest_spacing_mm();
  const Footprint<D> footprint(start);
  if (footprint.share == 0) {
    redistance(start, 4 * pixel_mm);
    return start;
  }
  const Terms<D> terms = terms_of(grey, range, options);
  LevelSetOptions level_set;
  level_set.max_steps = options.max_steps;
  level_set.band_pixels = narrow_band_pixels<D>;
  std::vector<float> leash;
  if (options.stay_mm > 0) {
    Field<D> reach = start;
    redistance(reach, options.stay_mm + 2 * pixel_mm);
    leash = std::move(reach.values);
  }
  Field<D> result = evolve<D>(std::move(start), terms.weighted, level_set, progress, observer).phi;
  for (std::size_t node = 0; node < leash.size(); ++node)
    result.values[node] = std::min(result.values[node], leash[node] + static_cast<float>(options.stay_mm));
  require_sound(footprint, result, options, where);
  return result;
}

template Field<2> evolve_region(Field<2>, const Field<2>&, const std::optional<GreyRange>&, const EvolutionOptions&,
                                const std::string&, const Progress&, const LevelSetObserver<2>&);
template Field<3> evolve_region(Field<3>, const Field<3>&, const std::optional<GreyRange>&, const EvolutionOptions&,
                                const std::string&, const Progress&, const LevelSetObserver<3>&);

}  // namespace isostack
