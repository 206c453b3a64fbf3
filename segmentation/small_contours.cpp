#include "segmentation/small_contours.h"

namespace isostack {

OnePixelContours find_one_pixel_contours(const ContourStack& organ) {
  OnePixelContours found;
  for (const ContourSlice& slice : organ.slices)
    for (const Contour& contour : slice.contours) {
      constexpr double most_pixels = 2;  // a diamond from pixel centre to pixel centre
      const double pixel_mm2 = slice.pose.spacing_mm.prod();
      if (contour.depth % 2 != 0 || contour.points_mm.size() != 4) continue;
      if (signed_area_mm2(contour) > most_pixels * pixel_mm2) continue;
      if (found.count++ == 0) found.first_slice = slice.name;
    }
  return found;
}

std::string remark_on_one_pixel_contours(const ContourStack& organ) {
  const OnePixelContours found = find_one_pixel_contours(organ);
  if (found.count == 0) return {};
  std::string remark = organ.name;
  remark.append(": ").append(std::to_string(found.count));
  remark.append(found.count == 1 ? " contour surrounds" : " contours surround");
  remark.append(" a single pixel (first on ").append(found.first_slice);
  return remark.append("): noise, or detail too small for the image");
}

}  // namespace isostack
