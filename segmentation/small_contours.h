#pragma once

#include <cstddef>
#include <string>

#include "recon/geometry/contour.h"

namespace isostack {

/// Contours that trace_contours drew around one pixel: noise, or detail at the limit of what the image resolves.
struct OnePixelContours {
  std::size_t count = 0;
  std::string first_slice;  ///< name of the first slice with one; empty without any
};

/// Looks at outer contours; a contour around one pixel has four points, and around two it has six.
OnePixelContours find_one_pixel_contours(const ContourStack& organ);

/// A sentence for the user; empty without any.
std::string remark_on_one_pixel_contours(const ContourStack& organ);

}  // namespace isostack
