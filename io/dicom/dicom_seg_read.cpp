#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/dicom/dicom_seg.h"
#include "io/dicom/dicom_seg_frames.h"
#include "io/dicom/dicom_seg_grid.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr std::size_t most_voxels = std::size_t{1} << 31;  // of all layers together

/// Sorts the pixels of frames into the voxels of a label map.
class MapBuilder {
 public:
  MapBuilder(const SegmentationHeader& header, const FrameGrid& grid, const SegmentationFrames& frames)
      : header_(header), grid_(grid), frames_(frames) {
    plane_ = static_cast<std::size_t>(grid.grid.size.x()) * static_cast<std::size_t>(grid.grid.size.y());
    if (header.type == SegmentationType::kFractional) least_value_ = std::max(1, (header.fractional_maximum + 1) / 2);
  }

  /// Each segment goes into the first layer where it overlaps no other.
  LabelMap layers() {
    std::map<std::uint16_t, std::vector<std::size_t>> frames_of;
    for (std::size_t f = 0; f < header_.segment_of_frame.size(); ++f)
      if (grid_.plane_of_frame[f] >= 0) frames_of[header_.segment_of_frame[f]].push_back(f);
    LabelMap map{.layers = {LabelVolume(grid_.grid)}, .segments = header_.segments};
    for (Segment& segment : map.segments) {
      const std::vector<std::size_t>& frames = frames_of[segment.value];
      const auto layer = std::find_if(map.layers.begin(), map.layers.end(),
                                      [&](const LabelVolume& taken) { return is_free(taken, frames); });
      segment.layer = static_cast<std::size_t>(layer - map.layers.begin());
      if (layer == map.layers.end()) add_layer(map);
      for (const std::size_t f : frames)
        for_each_voxel(
            f, [&](std::size_t voxel, std::uint16_t) { map.layers[segment.layer].voxels[voxel] = segment.value; });
    }
    return map;
  }

  /// Pixels that hold the segment's number.
  LabelMap label_map() {
    LabelMap map{.layers = {LabelVolume(grid_.grid)}, .segments = header_.segments};
    for (std::size_t f = 0; f < grid_.plane_of_frame.size(); ++f) {
      if (grid_.plane_of_frame[f] < 0) continue;
      for_each_voxel(f, [&](std::size_t voxel, std::uint16_t value) { map.layers.front().voxels[voxel] = value; });
    }
    return map;
  }

 private:
  template <class Call>
  void for_each_voxel(std::size_t frame, Call call) const {
    const std::size_t begin = plane_ * static_cast<std::size_t>(grid_.plane_of_frame[frame]);
    frames_.for_each_set(frame, [&](std::size_t pixel, std::uint16_t value) {
      if (value >= least_value_) call(begin + pixel, value);
    });
  }

  bool is_free(const LabelVolume& layer, const std::vector<std::size_t>& frames) const {
    bool free = true;
    for (const std::size_t f : frames)
      for_each_voxel(f, [&](std::size_t voxel, std::uint16_t) { free = free && layer.voxels[voxel] == 0; });
    return free;
  }

  void add_layer(LabelMap& map) const {
    if ((map.layers.size() + 1) * grid_.grid.voxel_count() > most_voxels)
      throw InputError(header_.image.name, "more segments overlap than memory has room for",
                       "split the file into one per segment");
    map.layers.emplace_back(grid_.grid);
  }

  const SegmentationHeader& header_;
  const FrameGrid& grid_;
  const SegmentationFrames& frames_;
  std::size_t plane_ = 0;
  int least_value_ = 1;
};

LabelMap map_on(const FrameGrid& grid, const SegmentationHeader& header, const SegmentationFrames& frames) {
  MapBuilder builder(header, grid, frames);
  LabelMap map = header.type == SegmentationType::kLabelMap ? builder.label_map() : builder.layers();
  map.warnings = header.warnings;
  map.warnings.insert(map.warnings.end(), grid.warnings.begin(), grid.warnings.end());
  return map;
}

}  // namespace

bool is_dicom_seg(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path) || !looks_like_dicom(path)) return false;
  try {
    return read_dicom_header(path).kind == DicomKind::kSegmentation;
  } catch (const Error&) {
    return false;  // whoever reads it will say what is wrong
  }
}

Grid read_dicom_seg_grid(const std::filesystem::path& path) {
  return grid_of_frames(read_segmentation_header(path).image).grid;
}

LabelMap read_dicom_seg(const std::filesystem::path& path) {
  const SegmentationHeader header = read_segmentation_header(path);
  const FrameGrid grid = grid_of_frames(header.image);
  return map_on(grid, header, SegmentationFrames(header));
}

std::vector<LabelMap> read_dicom_seg_planes(const std::filesystem::path& path) {
  const SegmentationHeader header = read_segmentation_header(path);
  std::vector<FrameGrid> grids;
  try {
    grids.push_back(grid_of_frames(header.image));
  } catch (const UnevenFrames& error) {
    grids = planes_of_frames(header.image);
    grids.front().warnings.push_back(fmt::format("uneven frames: {}; each of its {} planes is taken at its own place",
                                                 error.problem(), grids.size()));
  }
  const SegmentationFrames frames(header);
  std::vector<LabelMap> maps;
  for (const FrameGrid& grid : grids) {
    maps.push_back(map_on(grid, header, frames));
    if (maps.size() > 1) maps.back().warnings.clear();
  }
  return maps;
}

}  // namespace isostack
