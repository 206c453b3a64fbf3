#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/metrics/slice_agreement.h"
#include "viewers/scene.h"
#include "viewers/view_planes.h"

namespace isostack {

/// Where the visible surfaces cut a plane. Do the contours drawn there agree?
struct PlaneCut {
  struct Line {
    std::size_t surface;
    std::vector<Contour> contours;  ///< in the plane's slice coordinates
  };
  struct Agreement {
    std::size_t organ, surface;
    SliceAgreement of_slice;
  };
  std::vector<Line> lines;
  std::vector<Agreement> agreements;
};

/// `surface_of_organ`: which surface goes through the organ's contours; -1: none.
PlaneCut cut_by_plane(const ViewPlane& plane, const Scene& scene, const std::vector<int>& surface_of_organ);

/// "liver 0.12 mm mean, 0.80 mm largest from its contour"; empty when there is nothing to compare.
std::string to_text(const PlaneCut& cut, const Scene& scene);

}  // namespace isostack
