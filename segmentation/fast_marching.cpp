#include "segmentation/fast_marching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "segmentation/derivatives.h"

namespace isostack {

namespace {

/// Distance to the zero set along the normal from φ + |∇φ| s + φ_nn s²/2 = 0; nothing where φ bends too much
/// within a pixel for the expansion to be trusted (noise, steps).
template <int D>
std::optional<double> distance_by_expansion(const Derivatives<D>& derivatives, double value, double pixel_mm) {
  const auto gradient = derivatives.gradient();
  const double norm = gradient.norm();
  if (!(norm > 0)) return std::nullopt;
  const double second = gradient.dot(derivatives.hessian * gradient) / (norm * norm);
  constexpr double largest_bend = 0.7, largest_bend_along_normal = 0.25;
  if ((derivatives.forward - derivatives.backward).cwiseAbs().maxCoeff() > largest_bend * norm ||
      std::abs(second) * pixel_mm > largest_bend_along_normal * norm)
    return std::nullopt;
  const double discriminant = norm * norm - 2 * second * value;
  if (discriminant < 0) return std::nullopt;
  return std::abs(2 * value / (norm + std::sqrt(discriminant)));
}

template <int D>
class Marcher {
 public:
  Marcher(Field<D>& phi, double band_mm)
      : phi_(phi), band_mm_(band_mm), distance_(phi.values.size(), infinity), is_known_(phi.values.size(), 0) {}

  void run() {
    initialise();
    while (!front_.empty()) {
      const auto [distance, node] = front_.top();
      front_.pop();
      if (is_known_[node]) continue;
      if (distance > band_mm_) break;
      is_known_[node] = 1;
      update_neighbours(node);
    }
    for (std::size_t node = 0; node < distance_.size(); ++node)
      phi_.values[node] = std::copysign(is_known_[node] ? std::min(distance_[node], band_mm_) : band_mm_, sign(node));
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  using Entry = std::pair<double, std::size_t>;

  double sign(std::size_t node) const { return phi_.values[node] >= 0 ? 1 : -1; }

  template <class Visit>
  void for_each_neighbour(std::size_t node, Visit visit) const {
    const auto position = phi_.position_of(node);
    for (int axis = 0; axis < D; ++axis) {
      const std::size_t stride = phi_.stride(axis);
      if (position[axis] > 0) visit(axis, node - stride);
      if (position[axis] + 1 < phi_.size[axis]) visit(axis, node + stride);
    }
  }

  void initialise() {
    std::vector<std::size_t> near;
    for (std::size_t node = 0; node < distance_.size(); ++node) {
      const double by_crossings = distance_by_crossings(node);
      if (by_crossings == infinity) continue;
      distance_[node] = distance_by_expansion(derivatives_at(phi_, node), phi_.values[node], phi_.smallest_spacing_mm())
                            .value_or(by_crossings);
      is_known_[node] = 1;
      near.push_back(node);
    }
    for (std::size_t node : near) update_neighbours(node);
  }

  /// Distance to the plane through the nearest crossing on every axis; infinite away from the zero set.
  double distance_by_crossings(std::size_t node) const {
    std::array<double, D> nearest;
    nearest.fill(infinity);
    for_each_neighbour(node, [&](int axis, std::size_t neighbour) {
      if (sign(neighbour) == sign(node)) return;
      const double fraction = phi_.values[node] / (phi_.values[node] - phi_.values[neighbour]);
      nearest[axis] = std::min(nearest[axis], fraction * phi_.spacing_mm[axis]);
    });
    double sum = 0;
    for (double d : nearest) sum += 1 / (d * d);
    return sum > 0 ? 1 / std::sqrt(sum) : infinity;
  }

  void update_neighbours(std::size_t node) {
    for_each_neighbour(node, [&](int, std::size_t neighbour) {
      if (is_known_[neighbour] || sign(neighbour) != sign(node)) return;
      const double distance = solve(neighbour);
      if (distance >= distance_[neighbour]) return;
      distance_[neighbour] = distance;
      front_.emplace(distance, neighbour);
    });
  }

  /// One axis of |∇u|² = 1 as (slope·u − offset)².
  struct Difference {
    double slope, offset, neighbour;
  };

  /// Distance of a known node as seen from this side: negative across the zero set.
  double seen_from(double side, std::size_t node) const { return side * sign(node) * distance_[node]; }

  std::optional<Difference> upwind_difference(std::size_t node, int axis, int position) const {
    const std::size_t stride = phi_.stride(axis);
    const double h = phi_.spacing_mm[axis], side = sign(node);
    std::optional<Difference> best;
    for (const int step : {-1, 1}) {
      const auto reachable = [&](int steps) {
        const int there = position + steps * step;
        return there >= 0 && there < phi_.size[axis];
      };
      const auto at = [&](int steps) {
        return step < 0 ? node - static_cast<std::size_t>(steps) * stride
                        : node + static_cast<std::size_t>(steps) * stride;
      };
      if (!reachable(1) || !is_known_[at(1)]) continue;
      const double first = seen_from(side, at(1));
      if (best && best->neighbour <= first) continue;
      best = Difference{1 / h, first / h, first};
      if (!reachable(2) || !is_known_[at(2)]) continue;
      const double second = seen_from(side, at(2));
      if (second <= first) best = Difference{1.5 / h, (2 * first - 0.5 * second) / h, first};
    }
    return best;
  }

  double solve(std::size_t node) const {
    const auto position = phi_.position_of(node);
    std::vector<Difference>& used = used_;
    used.clear();
    for (int axis = 0; axis < D; ++axis)
      if (const auto difference = upwind_difference(node, axis, position[axis])) used.push_back(*difference);
    std::sort(used.begin(), used.end(),
              [](const Difference& a, const Difference& b) { return a.neighbour < b.neighbour; });
    // An axis whose neighbour is farther than the solution is not upwind: solve again without it.
    for (; !used.empty(); used.pop_back()) {
      double a = 0, b = 0, c = -1;
      for (const Difference& d : used) {
        a += d.slope * d.slope;
        b += d.slope * d.offset;
        c += d.offset * d.offset;
      }
      const double discriminant = b * b - a * c;
      if (discriminant < 0) continue;
      const double distance = (b + std::sqrt(discriminant)) / a;
      if (distance >= used.back().neighbour) return distance;
    }
    return infinity;
  }

  Field<D>& phi_;
  const double band_mm_;
  std::vector<double> distance_;  ///< unsigned
  std::vector<char> is_known_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front_;  ///< ties by node: one order on every machine
  mutable std::vector<Difference> used_;
};

}  // namespace

template <int D>
void redistance(Field<D>& phi, double band_mm) {
  Marcher<D>(phi, band_mm).run();
}

template void redistance(Field<2>&, double);
template void redistance(Field<3>&, double);

}  // namespace isostack
