#include "segmentation/region_term.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "segmentation/curve_distance.h"

namespace isostack {

template <int D>
RegionTerm<D>::RegionTerm(SharedField<D> image, const RegionOptions& options)
    : image_(std::move(image)), options_(options) {}

template <int D>
void RegionTerm<D>::start(const Field<D>& phi) {
  phi_ = &phi;
  whole_ = {};
  if (options_.window_mm > 0) return;
  for (std::size_t node = 0; node < phi.values.size(); ++node) {
    const bool inside = is_inside(phi.values[node]);
    whole_.grey[inside] += image_->values[node];
    ++whole_.count[inside];
  }
}

template <int D>
void RegionTerm<D>::changed_side(std::size_t node, bool is_inside_now) {
  const double grey = image_->values[node];
  whole_.grey[is_inside_now] += grey;
  ++whole_.count[is_inside_now];
  whole_.grey[!is_inside_now] -= grey;
  --whole_.count[!is_inside_now];
}

template <int D>
typename RegionTerm<D>::Sums RegionTerm<D>::sums_around(std::size_t node) const {
  auto first = phi_->position_of(node), last = first;
  for (int axis = 0; axis < D; ++axis) {
    const int reach = static_cast<int>(options_.window_mm / phi_->spacing_mm[axis]);
    first[axis] = std::max(0, first[axis] - reach);
    last[axis] = std::min(phi_->size[axis] - 1, last[axis] + reach);
  }
  Sums sums;
  for (auto at = first; at[D - 1] <= last[D - 1];) {
    const std::size_t line = phi_->node_at(at);
    for (std::size_t i = line; i <= line + static_cast<std::size_t>(last[0] - first[0]); ++i) {
      const bool inside = is_inside(phi_->values[i]);
      sums.grey[inside] += image_->values[i];
      ++sums.count[inside];
    }
    for (int axis = 1; axis < D; ++axis) {
      if (++at[axis] <= last[axis] || axis == D - 1) break;
      at[axis] = first[axis];
    }
  }
  return sums;
}

template <int D>
double RegionTerm<D>::propagation(std::size_t node) const {
  const Sums& sums = options_.window_mm > 0 ? sums_around(node) : whole_;
  if (sums.count[0] <= 0 || sums.count[1] <= 0) return 0;
  const double outer = sums.grey[0] / sums.count[0], inner = sums.grey[1] / sums.count[1];
  if (inner == outer) return 0;
  return std::clamp((2 * static_cast<double>(image_->values[node]) - inner - outer) / (inner - outer), -1.0, 1.0);
}

template class RegionTerm<2>;
template class RegionTerm<3>;

}  // namespace isostack
