#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "recon/geometry/color.h"

namespace isostack {

/// One contour as an RT Structure Set holds it.
struct RtContour {
  std::string type;                        ///< "CLOSED_PLANAR", "POINT", ...
  std::vector<Eigen::Vector3d> points_mm;  ///< world
};

/// One region of interest. The name is UTF-8 and never empty.
struct RtRoi {
  std::string name;
  std::string interpreted_type;
  std::optional<Color> color;
  std::vector<RtContour> contours;
};

/// What an RT Structure Set says, before any of it is understood as planes. Nothing in it identifies a patient.
struct RtStructureSet {
  std::vector<RtRoi> rois;
  std::vector<std::string> series_uids;  ///< of the images it refers to
  std::vector<std::string> warnings;
};

/// Throws InputError naming the file when it is damaged, no structure set, or has no list of ROIs.
RtStructureSet read_rtstruct_file(const std::filesystem::path& path);

}  // namespace isostack
