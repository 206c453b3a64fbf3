#pragma once

#include <filesystem>
#include <vector>

#include "io/inspect.h"
#include "recon/geometry/slice_pose.h"

namespace isostack {

/// Fills in what follows from poses (in order) of equally large slices: counts, spacing, directions, gaps,
/// tilt, extent and bounds.
void summarise_poses(const std::vector<SlicePose>& poses, int columns, int rows, SeriesSummary& summary);

/// Grows the summary's bounds.
class BoundsBuilder {
 public:
  explicit BoundsBuilder(SeriesSummary& summary) : summary_(summary) {}
  void add(const Eigen::Vector3d& point_in_world_mm);

 private:
  SeriesSummary& summary_;
  bool empty_ = true;
};

/// Adds the organs of a DICOM structure set, their bounds and what its reader warns of.
void summarise_structure_set(const std::filesystem::path& path, SeriesSummary& summary);

/// Adds the segments of a DICOM segmentation, where its planes lie, and what its reader warns of.
void summarise_segmentation(const std::filesystem::path& path, SeriesSummary& summary);

std::vector<SeriesSummary> inspect_dicom(const std::filesystem::path& path);
SeriesSummary inspect_volume(const std::filesystem::path& path);
SeriesSummary inspect_images(const std::filesystem::path& path);
SeriesSummary inspect_mesh(const std::filesystem::path& path);
std::vector<SeriesSummary> inspect_contours(const std::filesystem::path& path);

}  // namespace isostack
