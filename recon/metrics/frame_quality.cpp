#include "recon/metrics/frame_quality.h"

#include <algorithm>
#include <cmath>

#include "recon/metrics/contour_measures.h"
#include "recon/metrics/mesh_curvature.h"
#include "recon/metrics/mesh_measures.h"

namespace isostack {

double FrameQuality::largest_curvature() const {
  return std::max(std::abs(lowest_curvature), std::abs(highest_curvature));
}

FrameQuality frame_quality(const Shape& shape, const FrameQualityOptions& options) {
  if (const auto* figure = std::get_if<ContourSlice>(&shape)) {
    const double scale_mm =
        options.curvature_scale_mm > 0 ? options.curvature_scale_mm : figure->pose.spacing_mm.minCoeff();
    const ContourMeasures m = measure(figure->contours, scale_mm);
    return {.components = m.components,
            .holes = m.holes,
            .content = m.area_mm2,
            .boundary = m.perimeter_mm,
            .lowest_curvature = m.lowest_curvature_per_mm,
            .highest_curvature = m.highest_curvature_per_mm};
  }
  const auto& mesh = std::get<TriangleMesh>(shape);
  if (mesh.triangles.empty()) return {};
  const MeshMeasures m = measure(mesh);
  const CurvatureRange range = mean_curvature_range_per_mm(mesh);
  return {.components = m.components,
          .holes = static_cast<std::size_t>(std::max(0.0, std::round(m.genus))),
          .content = m.volume_mm3,
          .boundary = m.area_mm2,
          .lowest_curvature = range.percentile1,
          .highest_curvature = range.percentile99};
}

}  // namespace isostack
