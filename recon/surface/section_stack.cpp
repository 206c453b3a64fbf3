#include "recon/surface/section_stack.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/surface/plane_section.h"

namespace isostack {

namespace {

/// A plane that passes a vertex closely cuts its edges at nearly the same place.
void drop_repetitions(Contour& contour) {
  constexpr double same_place_mm = 0.01;
  std::vector<Eigen::Vector2d> kept;
  for (const Eigen::Vector2d& point : contour.points_mm)
    if (kept.empty() || (point - kept.back()).norm() > same_place_mm) kept.push_back(point);
  while (kept.size() > 1 && (kept.front() - kept.back()).norm() <= same_place_mm) kept.pop_back();
  if (kept.size() >= 3) contour.points_mm = std::move(kept);
}

}  // namespace

ContourStack section_stack(const TriangleMesh& mesh, const std::vector<ContourSlice>& planes, const std::string& name,
                           const Progress& progress) {
  const MeshMeasures measures = measure(mesh);
  if (!measures.watertight() || mesh.triangles.empty())
    throw GeometryError(name.empty() ? mesh.name : name, "the surface is not closed, so it has no inside to be cut",
                        "close its holes and repair edges with more than two triangles");
  ContourStack stack{.name = name.empty() ? mesh.name : name, .slices = planes, .color = mesh.color, .roi_type = {}};
  constexpr std::size_t planes_per_report = 16;
  for (std::size_t begin = 0; begin < planes.size(); begin += planes_per_report) {
    progress.report("sections", static_cast<double>(begin) / static_cast<double>(planes.size()));
    tbb::parallel_for(begin, std::min(planes.size(), begin + planes_per_report), [&](std::size_t i) {
      stack.slices[i].contours = plane_section(mesh, planes[i].pose);
      for (Contour& contour : stack.slices[i].contours) drop_repetitions(contour);
    });
  }
  progress.report("sections", 1);
  return stack;
}

}  // namespace isostack
