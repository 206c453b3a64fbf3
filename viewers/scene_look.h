#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "recon/geometry/slice_pose.h"
#include "viewers/grey_window.h"

namespace isostack {

enum class Quality {
  fine,  ///< hollows darkened, see-through layers in their true order: seconds a frame without a graphics card
  fast   ///< for windows: a tenth of a second
};

/// How a scene is shown.
struct SceneLook {
  bool dark = false;                                   ///< light drawing on a dark ground
  Eigen::Vector3d view_from = {0.5, -0.9, 0.35};       ///< direction from the scene's centre to the camera, LPS
  std::optional<Eigen::Vector3d> view_up = {};         ///< LPS; none: superior, anterior where that is the view
  std::vector<Eigen::Vector3d> framed_points_mm = {};  ///< what fills the view; empty: all that is visible
  double filled = 0.80;                                ///< share of the height that they fill; of the width some more
  bool marks = true;                                   ///< scale bar and the cube with the patient's directions
  bool axes = false;                                   ///< box round what is visible, with mm along L, P and S
  std::optional<GreyWindow> grey = std::nullopt;       ///< none: automatic, from all slices
  Quality quality = Quality::fine;
};

/// The look at a slice as its image is: columns to the right, rows down.
SceneLook facing(const SlicePose& pose, SceneLook look = {});

}  // namespace isostack
