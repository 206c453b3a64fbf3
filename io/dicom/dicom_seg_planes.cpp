#include "io/dicom/dicom_seg_planes.h"

#include <algorithm>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr std::size_t value_count = 1 << 16;

std::size_t plane_size(const Grid& grid) {
  return static_cast<std::size_t>(grid.size.x()) * static_cast<std::size_t>(grid.size.y());
}

/// The organs in the order of their numbers, and the value that each has in its layer.
struct NumberedSegments {
  std::vector<Segment> segments;
  std::vector<std::uint16_t> values;
};

NumberedSegments numbered(const LabelMap& map) {
  NumberedSegments result{all_segments(map), {}};
  const auto by_value = [](const Segment& a, const Segment& b) { return a.value < b.value; };
  std::vector<Segment> sorted = result.segments;
  std::stable_sort(sorted.begin(), sorted.end(), by_value);
  bool counts_from_one = true;
  for (std::size_t i = 0; i < sorted.size(); ++i) counts_from_one = counts_from_one && sorted[i].value == i + 1;
  if (counts_from_one) result.segments = std::move(sorted);
  for (std::size_t i = 0; i < result.segments.size(); ++i) {
    result.values.push_back(result.segments[i].value);
    result.segments[i].value = static_cast<std::uint16_t>(i + 1);
  }
  return result;
}

/// For each segment the planes that hold a voxel of it.
std::vector<std::vector<int>> planes_with_voxels(const LabelMap& map, const NumberedSegments& numbered) {
  const Grid& grid = map.layers.front().grid;
  std::vector<std::vector<int>> planes(numbered.segments.size());
  for (std::size_t layer = 0; layer < map.layers.size(); ++layer)
    for (int k = 0; k < grid.size.z(); ++k) {
      std::vector<bool> present(value_count);
      const std::uint16_t* voxels = map.layers[layer].voxels.data() + grid.offset(0, 0, k);
      for (std::size_t i = 0; i < plane_size(grid); ++i) present[voxels[i]] = true;
      for (std::size_t s = 0; s < planes.size(); ++s)
        if (numbered.segments[s].layer == layer && present[numbered.values[s]]) planes[s].push_back(k);
    }
  return planes;
}

/// Adds frames of the first segment where the grid's ends have none.
void reach_both_ends(std::vector<std::vector<int>>& planes, int last) {
  for (const int end : {0, last}) {
    const bool reached = std::any_of(planes.begin(), planes.end(), [&](const std::vector<int>& ks) {
      return std::find(ks.begin(), ks.end(), end) != ks.end();
    });
    if (!reached) planes.front().push_back(end);
  }
  std::sort(planes.front().begin(), planes.front().end());
}

std::string packed_bits(const LabelMap& map, const NumberedSegments& numbered,
                        const std::vector<SegmentPlane>& frames) {
  const Grid& grid = map.layers.front().grid;
  const std::size_t size = plane_size(grid);
  std::string bits((frames.size() * size + 15) / 16 * 2, '\0');
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const std::size_t s = frames[f].segment - 1u, begin = f * size;
    const std::uint16_t* voxels = map.layers[numbered.segments[s].layer].voxels.data() + grid.offset(0, 0, frames[f].k);
    for (std::size_t i = 0; i < size; ++i)
      if (voxels[i] == numbered.values[s]) {
        char& byte = bits[(begin + i) / 8];
        byte = static_cast<char>(static_cast<unsigned char>(byte) | 1u << (begin + i) % 8);
      }
  }
  return bits;
}

}  // namespace

SegmentPlanes planes_of_segments(const LabelMap& map, const std::string& where) {
  if (map.layers.empty() || map.layers.front().voxels.empty())
    throw InputError(where, "there are no labels to write", "give a label map");
  const Grid& grid = map.layers.front().grid;
  const NumberedSegments organs = numbered(map);
  if (organs.segments.empty()) throw InputError(where, "all voxels are background", "write at least one organ");
  std::vector<std::vector<int>> planes = planes_with_voxels(map, organs);
  reach_both_ends(planes, grid.size.z() - 1);
  SegmentPlanes result{.segments = organs.segments, .frames = {}, .bits = {}};
  for (std::size_t s = 0; s < planes.size(); ++s)
    for (const int k : planes[s]) result.frames.push_back({static_cast<std::uint16_t>(s + 1), k});
  constexpr std::size_t most_bytes = 0xfffffffe;
  if (std::max(grid.size.x(), grid.size.y()) > 65535 || organs.segments.size() > 65535 ||
      result.frames.size() * plane_size(grid) / 8 > most_bytes)
    throw InputError(where, "it is too large for one DICOM file", "write .seg.nrrd, or one file per organ");
  result.bits = packed_bits(map, organs, result.frames);
  return result;
}

}  // namespace isostack
