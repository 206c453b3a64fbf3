#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "recon/geometry/slice_pose.h"

namespace isostack {

/// Points of one surface or landmark, such as "LAX_RV_SEPTUM" or "MITRAL_VALVE", on one slice.
struct GuidePointSet {
  std::vector<Eigen::Vector3d> points_mm;  ///< world
  std::string time_frame;
};

/// By slice number, then by the surface's name.
using GuidePoints = std::map<int, std::map<std::string, GuidePointSet>>;

/// True of the first line of a file of guide points.
bool is_guide_point_header(const std::string& line);

/// Throws InputError naming file and line.
GuidePoints read_guide_point_table(const std::filesystem::path& path);

/// Poses by slice number. Throws InputError naming file and line.
std::map<int, SlicePose> read_slice_poses(const std::filesystem::path& path);

/// SliceInfoFile.txt, or the only SliceInfo*.txt, in the folder of the guide points. Throws InputError when there is
/// none.
std::filesystem::path slice_info_beside(const std::filesystem::path& guide_points);

}  // namespace isostack
