#pragma once

#include <Eigen/Core>
#include <vector>

#include "cli/morph_frames.h"
#include "recon/geometry/picture.h"
#include "recon/geometry/progress.h"

namespace isostack::cli {

struct MorphPictureOptions {
  int size_pixels = 320;  ///< longer side
  Eigen::Vector3d view_from = {0.5, -0.9, 0.35};
};

/// One picture per frame, all of one size and seen the same way: figures filled, dark on white; bodies drawn as by
/// `view`, which needs a display. A frame of nothing is white. Throws InputError as draw_picture() does.
std::vector<Picture> pictures_of(const std::vector<MorphFrame>& frames, const MorphPictureOptions& options,
                                 const Progress& progress);

}  // namespace isostack::cli
