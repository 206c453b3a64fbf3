#include "viewers/window/plane_cut.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/geometry/pixel_lattice.h"
#include "viewers/cut_lines.h"

namespace isostack {

PlaneCut cut_by_plane(const ViewPlane& plane, const Scene& scene, const std::vector<int>& surface_of_organ) {
  PlaneCut cut;
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
    if (scene.surfaces[i].visible) cut.lines.push_back({i, cut_lines(scene.surfaces[i].mesh, plane.pose)});
  for (const ViewPlane::Drawn& drawn : plane.contours) {
    if (drawn.organ >= surface_of_organ.size()) continue;
    const auto line = std::find_if(cut.lines.begin(), cut.lines.end(), [&](const PlaneCut::Line& one) {
      return static_cast<int>(one.surface) == surface_of_organ[drawn.organ];
    });
    const ContourStack& organ = scene.contours[drawn.organ].stack;
    const ContourSlice& slice = organ.slices[drawn.slice];
    if (line == cut.lines.end() || slice.contours.empty()) continue;
    PixelLattice lattice = lattice_of(slice, organ);
    SliceComparison comparison;
    comparison.add(moved_to(lattice.pose, line->contours, plane.pose),
                   moved_to(lattice.pose, slice.contours, slice.pose), lattice);
    cut.agreements.push_back({drawn.organ, line->surface, comparison.agreement()});
  }
  return cut;
}

std::string to_text(const PlaneCut& cut, const Scene& scene) {
  std::string text;
  for (const PlaneCut::Agreement& one : cut.agreements) {
    const std::string& name = scene.contours[one.organ].stack.name;
    if (!text.empty()) text += "   ";
    text += one.of_slice.has_distances ? fmt::format("{}: surface {:.2f} mm mean, {:.2f} mm largest from the contour",
                                                     name, one.of_slice.mean_mm, one.of_slice.largest_mm)
                                       : fmt::format("{}: the surface misses the contour", name);
  }
  return text;
}

}  // namespace isostack
