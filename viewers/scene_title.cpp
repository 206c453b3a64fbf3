#include "viewers/scene_title.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "recon/metrics/mesh_measures.h"

namespace isostack {

namespace {

std::string counted(std::size_t count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string about_surfaces(const std::vector<SceneSurface>& surfaces) {
  std::size_t triangles = 0;
  double volume_mm3 = 0;
  bool all_closed = true;
  for (const SceneSurface& surface : surfaces) {
    const MeshMeasures measures = measure(surface.mesh);
    triangles += measures.triangles;
    volume_mm3 += measures.volume_mm3;
    all_closed = all_closed && measures.watertight();
  }
  const std::string count = counted(triangles, "triangle");
  return all_closed ? fmt::format("{:.4g} ml, {}", volume_mm3 / 1000, count) : count;
}

std::string about_contours(const std::vector<SceneContours>& organs) {
  std::size_t contours = 0, slices = 0;
  for (const SceneContours& organ : organs)
    for (const ContourSlice& slice : organ.stack.slices) {
      contours += slice.contours.size();
      slices += slice.contours.empty() ? 0 : 1;
    }
  return counted(contours, "contour") + " on " + counted(slices, "slice");
}

}  // namespace

std::string title_of(const Scene& scene, const std::vector<std::string>& names) {
  std::vector<std::string> numbers;
  if (!scene.surfaces.empty()) numbers.push_back(about_surfaces(scene.surfaces));
  if (!scene.contours.empty()) numbers.push_back(about_contours(scene.contours));
  if (!scene.slices.empty()) numbers.push_back(counted(scene.slices.size(), "image"));
  constexpr std::size_t most_names = 4;
  std::vector<std::string> first(names.begin(),
                                 names.begin() + static_cast<std::ptrdiff_t>(std::min(most_names, names.size())));
  if (names.size() > most_names) first.push_back(fmt::format("{} more", names.size() - most_names));
  return fmt::format("{}\n{}", fmt::join(first, ", "), fmt::join(numbers, "; "));
}

}  // namespace isostack
