#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "io/dicom/dicom_seg_frames.h"
#include "io/dicom/dicom_seg_grid.h"
#include "io/dicom/dicom_seg_header.h"
#include "io/inspect_parts.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr std::uintmax_t most_bytes_to_count = std::uintmax_t{1} << 28;

/// Of one segment.
struct Counts {
  std::size_t voxels = 0;
  std::set<int> frames;  ///< that show it
};

/// By segment number.
std::map<int, Counts> count_voxels(const SegmentationHeader& header) {
  std::map<int, Counts> counts;
  const int least = header.type == SegmentationType::kFractional ? std::max(1, (header.fractional_maximum + 1) / 2) : 1;
  const SegmentationFrames frames(header);
  for (int frame = 0; frame < header.image.frames; ++frame) {
    const auto f = static_cast<std::size_t>(frame);
    Counts* last = nullptr;  // values come in runs
    int number = 0;
    frames.for_each_set(f, [&](std::size_t, std::uint16_t value) {
      if (value < least) return;
      const int of_value = header.type == SegmentationType::kLabelMap ? value : header.segment_of_frame[f];
      if (!last || of_value != number) {
        number = of_value;
        last = &counts[number];
        last->frames.insert(frame);
      }
      ++last->voxels;
    });
  }
  return counts;
}

/// All frames of one place count as one plane.
void add_places(const SegmentationHeader& header, SeriesSummary& summary) {
  std::vector<SlicePose> poses;
  for (const FrameGrid& plane : planes_of_frames(header.image))
    poses.push_back(pose_of_plane(plane.grid, 0, header.image.name));
  summary.slice_thickness_mm = header.image.frame_parts.front().slice_thickness_mm;
  summarise_poses(poses, header.image.columns, header.image.rows, summary);
  try {
    grid_of_frames(header.image);
  } catch (const UnevenFrames& error) {
    summary.warnings.push_back(
        fmt::format("uneven frames: {}; read as contours, each plane at its own place", error.problem()));
  }
}

std::vector<OrganSummary> segments_of(const SegmentationHeader& header) {
  std::vector<OrganSummary> organs;
  const bool can_count =
      !header.image.is_compressed &&
      std::max<std::uintmax_t>(header.image.pixel_bytes, header.plain_pixels.size()) <= most_bytes_to_count;
  const std::map<int, Counts> counts = can_count ? count_voxels(header) : std::map<int, Counts>();
  for (const Segment& segment : header.segments) {
    OrganSummary& organ = organs.emplace_back();
    organ.name = segment.name;
    organ.number = segment.value;
    organ.color = segment.color;
    if (const auto type = header.property_types.find(segment.value); type != header.property_types.end())
      organ.type = type->second;
    organ.frame_count = static_cast<std::size_t>(
        std::count(header.segment_of_frame.begin(), header.segment_of_frame.end(), segment.value));
    if (!can_count) continue;
    const auto counted = counts.find(segment.value);
    organ.voxel_count = counted == counts.end() ? 0 : counted->second.voxels;
    if (header.type == SegmentationType::kLabelMap && counted != counts.end())
      organ.frame_count = counted->second.frames.size();
  }
  return organs;
}

}  // namespace

void summarise_segmentation(const std::filesystem::path& path, SeriesSummary& summary) {
  try {
    const SegmentationHeader header = read_segmentation_header(path);
    if (summary.organs.empty()) add_places(header, summary);  // of several files, where the first one lies
    for (OrganSummary& organ : segments_of(header)) summary.organs.push_back(std::move(organ));
    summary.warnings.insert(summary.warnings.end(), header.warnings.begin(), header.warnings.end());
  } catch (const Error& error) {
    summary.warnings.push_back(fmt::format("unusable: {}", error.what()));
  }
}

}  // namespace isostack
