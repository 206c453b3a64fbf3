#include "segmentation/region.h"

#include <algorithm>
#include <limits>

namespace isostack {

Mask inside_of(const Image<float>& phi) { return (phi >= 0).cast<std::uint8_t>(); }

void impose(const Mask& inside, Image<float>& phi) {
  constexpr float never_zero = std::numeric_limits<float>::min();
  phi = (inside == inside_of(phi)).select(phi, (inside != 0).select(phi.abs(), -phi.abs().cwiseMax(never_zero)));
}

void keep_largest(std::vector<Image<float>>& phi) {
  std::vector<Mask> masks;
  for (const auto& plane : phi) masks.push_back(inside_of(plane));
  masks = largest_component(std::move(masks));
  for (std::size_t k = 0; k < phi.size(); ++k) impose(masks[k], phi[k]);
}

Field<3> field_of(const std::vector<Image<float>>& planes, const Eigen::Vector3d& spacing_mm) {
  Field<3> field{};
  field.size = {static_cast<int>(planes.front().cols()), static_cast<int>(planes.front().rows()),
                static_cast<int>(planes.size())};
  field.spacing_mm = {spacing_mm.x(), spacing_mm.y(), spacing_mm.z()};
  for (const auto& plane : planes) field.values.insert(field.values.end(), plane.data(), plane.data() + plane.size());
  return field;
}

std::vector<Image<float>> planes_of(const Field<3>& field) {
  std::vector<Image<float>> planes;
  auto value = field.values.begin();
  for (int k = 0; k < field.size[2]; ++k) {
    planes.emplace_back(field.size[1], field.size[0]);
    for (float& pixel : planes.back().reshaped<Eigen::RowMajor>()) pixel = static_cast<float>(*value++);
  }
  return planes;
}

void part_regions(std::vector<Image<float>*> distances_mm) {
  if (distances_mm.size() < 2) return;
  std::vector<float> depth(distances_mm.size());
  for (Eigen::Index pixel = 0; pixel < distances_mm.front()->size(); ++pixel) {
    // The two deepest; the first among equals, so that no pixel is left to two.
    std::size_t first = 0;
    float second_depth = -std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = distances_mm[i]->data()[pixel];
    for (std::size_t i = 1; i < depth.size(); ++i)
      if (depth[i] > depth[first]) first = i;
    for (std::size_t i = 0; i < depth.size(); ++i)
      if (i != first) second_depth = std::max(second_depth, depth[i]);
    if (second_depth < 0 && depth[first] < 0) continue;
    for (std::size_t i = 0; i < depth.size(); ++i) {
      const float rival = i == first ? second_depth : depth[first];
      float& value = distances_mm[i]->data()[pixel];
      value = std::min(value, (value - rival) / 2);
      if (i != first && value >= 0) value = -std::numeric_limits<float>::min();
    }
  }
}

}  // namespace isostack
