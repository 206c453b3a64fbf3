#include "segmentation/curve_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

#include "segmentation/derivatives.h"
#include "segmentation/pieces.h"

namespace isostack {

namespace {

/// From φ + |∇φ| s + φ_nn s²/2 = 0; nothing where φ bends too much within a pixel for the expansion to be
/// trusted (noise, steps).
template <int D>
std::optional<double> distance_by_expansion(const Derivatives<D>& derivatives, double value, double pixel_mm) {
  const auto gradient = derivatives.gradient();
  const double norm = gradient.norm();
  if (!(norm > 0)) return std::nullopt;
  constexpr double largest_bend = 0.7, largest_bend_along_normal = 0.25;
  if ((derivatives.forward - derivatives.backward).cwiseAbs().maxCoeff() > largest_bend * norm) return std::nullopt;
  const double second = gradient.dot(derivatives.hessian * gradient) / (norm * norm);
  if (std::abs(second) * pixel_mm > largest_bend_along_normal * norm) return std::nullopt;
  const double discriminant = norm * norm - 2 * second * value;
  if (discriminant < 0) return std::nullopt;
  return std::abs(2 * value / (norm + std::sqrt(discriminant)));
}

/// Distance to the plane through the nearest crossing on every axis.
template <int D>
double distance_by_crossings(const Field<D>& phi, const Lattice<D>& lattice, std::size_t node,
                             typename Lattice<D>::Sides sides) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, D> nearest;
  nearest.fill(infinity);
  const float value = phi.values[node];
  lattice.for_each_neighbour(sides, [&](int axis, std::ptrdiff_t step) {
    const float there = phi.values[lattice.moved(node, step)];
    if (is_inside(there) == is_inside(value)) return;
    const double fraction = value / (static_cast<double>(value) - static_cast<double>(there));
    nearest[axis] = std::min(nearest[axis], fraction * lattice.spacing_mm[axis]);
  });
  double sum = 0;
  for (const double d : nearest) sum += 1 / (d * d);
  return sum > 0 ? 1 / std::sqrt(sum) : infinity;
}

/// Sides of the nodes of one line along axis 0 as bytes, which are compared many at a time.
template <int D>
void read_sides(const Field<D>& phi, std::size_t first, std::vector<std::uint8_t>& sides) {
  const float* value = phi.values.data() + first;
  for (std::size_t i = 0; i < sides.size(); ++i) sides[i] = is_inside(value[i]);
}

/// Lists the nodes of one line along axis 0 that are beside the curve.
template <int D>
class LineScanner {
 public:
  LineScanner(const Field<D>& phi, const Lattice<D>& lattice)
      : phi_(phi), lattice_(lattice), own_(lattice.size[0]), other_(own_.size()), differs_(own_.size()) {}

  void scan(std::size_t first, std::vector<std::size_t>& found) {
    const std::size_t length = own_.size();
    read_sides(phi_, first, own_);
    std::fill(differs_.begin(), differs_.end(), std::uint8_t{0});
    for (std::size_t i = 0; i + 1 < length; ++i) differs_[i] |= own_[i] ^ own_[i + 1];
    for (std::size_t i = 1; i < length; ++i) differs_[i] |= own_[i] ^ own_[i - 1];
    const auto sides = lattice_.sides_of(first);
    lattice_.for_each_neighbour(sides, [&](int axis, std::ptrdiff_t step) {
      if (axis == 0) return;
      read_sides(phi_, lattice_.moved(first, step), other_);
      for (std::size_t i = 0; i < length; ++i) differs_[i] |= own_[i] ^ other_[i];
    });
    list(first, found);
  }

 private:
  void list(std::size_t first, std::vector<std::size_t>& found) const {
    const std::size_t length = differs_.size();
    for (std::size_t i = 0; i < length;) {
      std::uint64_t eight = 0;
      if (i + 8 <= length) std::memcpy(&eight, differs_.data() + i, 8);
      const std::size_t last = std::min(length, i + 8);
      if (i + 8 > length || eight != 0)
        for (std::size_t k = i; k < last; ++k)
          if (differs_[k]) found.push_back(first + k);
      i = last;
    }
  }

  const Field<D>& phi_;
  const Lattice<D>& lattice_;
  std::vector<std::uint8_t> own_, other_, differs_;
};

}  // namespace

template <int D>
std::vector<std::size_t> nodes_beside_curve(const Field<D>& phi, const Lattice<D>& lattice) {
  const std::size_t length = lattice.size[0];
  if (phi.values.empty()) return {};
  const Pieces lines{phi.values.size() / length, (1 << 18) / length + 1};
  std::vector<std::vector<std::size_t>> found(lines.number());
  lines.for_each([&](std::size_t piece, std::size_t first, std::size_t last) {
    LineScanner<D> scanner(phi, lattice);
    for (std::size_t line = first; line < last; ++line) scanner.scan(line * length, found[piece]);
  });
  if (found.size() == 1) return std::move(found.front());
  std::vector<std::size_t> nodes;
  for (const auto& part : found) nodes.insert(nodes.end(), part.begin(), part.end());
  return nodes;
}

template <int D>
void set_distances_beside_curve(Field<D>& phi, const Lattice<D>& lattice, const std::vector<std::size_t>& nodes) {
  std::vector<float> distances(nodes.size());
  Pieces{nodes.size(), 1 << 14}.for_each([&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      distances[i] = static_cast<float>(distance_beside_curve(phi, lattice, nodes[i], lattice.sides_of(nodes[i])));
  });
  constexpr float never_zero = std::numeric_limits<float>::min();  // −0 would be inside
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    float& value = phi.values[nodes[i]];
    value = is_inside(value) ? distances[i] : -std::max(distances[i], never_zero);
  }
}

template <int D>
double distance_beside_curve(const Field<D>& phi, const Lattice<D>& lattice, std::size_t node,
                             typename Lattice<D>::Sides sides) {
  const double pixel_mm = *std::min_element(lattice.spacing_mm.begin(), lattice.spacing_mm.end());
  const auto smooth = distance_by_expansion(derivatives_at(phi, lattice, node, sides), phi.values[node], pixel_mm);
  return smooth ? *smooth : distance_by_crossings(phi, lattice, node, sides);
}

template double distance_beside_curve(const Field<2>&, const Lattice<2>&, std::size_t, std::uint8_t);
template double distance_beside_curve(const Field<3>&, const Lattice<3>&, std::size_t, std::uint8_t);
template std::vector<std::size_t> nodes_beside_curve(const Field<2>&, const Lattice<2>&);
template std::vector<std::size_t> nodes_beside_curve(const Field<3>&, const Lattice<3>&);
template void set_distances_beside_curve(Field<2>&, const Lattice<2>&, const std::vector<std::size_t>&);
template void set_distances_beside_curve(Field<3>&, const Lattice<3>&, const std::vector<std::size_t>&);

}  // namespace isostack
