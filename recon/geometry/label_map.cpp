#include "recon/geometry/label_map.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr std::size_t value_count = 1 << 16;

std::vector<bool> values_in(const LabelVolume& layer) {
  std::vector<bool> present(value_count);
  std::uint16_t last = 0;  // labels come in runs
  for (const std::uint16_t value : layer.voxels)
    if (value != last) present[last = value] = true;
  return present;
}

bool overlaps(const LabelVolume& layer, const LabelVolume& mask) {
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    if (mask.voxels[i] != 0 && layer.voxels[i] != 0) return true;
  return false;
}

/// A value of the one layer for each segment: its own where no earlier one has it.
std::vector<std::uint16_t> distinct_values(const std::vector<Segment>& segments) {
  std::vector<bool> taken(value_count);
  std::vector<std::uint16_t> values;
  for (const Segment& segment : segments) {
    std::size_t value = segment.value;
    for (std::size_t next = 1; taken[value] && next < value_count; ++next)
      if (!taken[next]) value = next;
    taken[value] = true;
    values.push_back(static_cast<std::uint16_t>(value));
  }
  return values;
}

template <typename Predicate>
std::vector<Segment> kept(const std::vector<Segment>& segments, Predicate is_wanted) {
  std::vector<Segment> wanted;
  std::copy_if(segments.begin(), segments.end(), std::back_inserter(wanted), is_wanted);
  return wanted;
}

/// "1 (liver), 2 (kidney), 7"
std::string listed(const std::vector<Segment>& segments) {
  std::string list;
  for (const Segment& segment : segments) {
    const std::string number = std::to_string(segment.value);
    if (!list.empty()) list += ", ";
    list += number;
    if (segment.name != number) list.append(" (").append(segment.name).append(")");
  }
  return list;
}

}  // namespace

std::vector<Segment> all_segments(const LabelMap& map) {
  std::vector<Segment> segments = map.segments;
  for (std::size_t layer = 0; layer < map.layers.size(); ++layer) {
    std::vector<bool> unnamed = values_in(map.layers[layer]);
    for (const Segment& segment : map.segments)
      if (segment.layer == layer) unnamed[segment.value] = false;
    for (std::size_t value = 1; value < value_count; ++value)
      if (unnamed[value])
        segments.push_back({.name = std::to_string(value), .value = static_cast<std::uint16_t>(value), .layer = layer});
  }
  return segments;
}

std::vector<Segment> chosen_segments(const LabelMap& map, const std::string& choice, const std::string& where) {
  std::vector<Segment> all = all_segments(map);
  if (all.empty()) throw InputError(where, "no voxel has a label", "give a label image in which an organ is marked");
  if (choice == "all") return all;
  std::vector<Segment> chosen = kept(all, [&](const Segment& segment) { return segment.name == choice; });
  if (chosen.empty())
    chosen = kept(all, [&](const Segment& segment) { return std::to_string(segment.value) == choice; });
  if (chosen.empty())
    throw InputError(where, "no voxel has label " + choice, "choose one of the labels present: " + listed(all));
  return chosen;
}

void add_segment(LabelMap& map, const LabelVolume& mask, Segment segment) {
  const auto free = std::find_if(map.layers.begin(), map.layers.end(),
                                 [&](const LabelVolume& layer) { return !overlaps(layer, mask); });
  segment.layer = static_cast<std::size_t>(free - map.layers.begin());
  if (free == map.layers.end()) map.layers.emplace_back(mask.grid);
  LabelVolume& layer = map.layers[segment.layer];
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    if (mask.voxels[i] != 0) layer.voxels[i] = segment.value;
  map.segments.push_back(std::move(segment));
}

LabelMap flattened(LabelMap map, std::size_t* overlapping_voxels) {
  if (overlapping_voxels) *overlapping_voxels = 0;
  if (map.layers.size() < 2) return map;
  LabelMap flat{.layers = {LabelVolume(map.layers.front().grid)}, .segments = all_segments(map)};
  flat.warnings = std::move(map.warnings);
  const std::vector<std::uint16_t> values = distinct_values(flat.segments);
  std::vector<std::uint16_t>& voxels = flat.layers.front().voxels;
  for (std::size_t layer = 0; layer < map.layers.size(); ++layer) {
    std::vector<std::uint16_t> value_for(value_count);
    for (std::size_t s = 0; s < values.size(); ++s)
      if (flat.segments[s].layer == layer) value_for[flat.segments[s].value] = values[s];
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      const std::uint16_t value = value_for[map.layers[layer].voxels[i]];
      if (value == 0) continue;
      if (voxels[i] != 0 && overlapping_voxels) ++*overlapping_voxels;
      voxels[i] = value;
    }
  }
  for (std::size_t s = 0; s < values.size(); ++s) {
    flat.segments[s].layer = 0;
    flat.segments[s].value = values[s];
  }
  return flat;
}

}  // namespace isostack
