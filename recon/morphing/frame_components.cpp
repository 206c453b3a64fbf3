#include "recon/morphing/frame_components.h"

#include <algorithm>

#include "recon/metrics/mesh_measures.h"

namespace isostack {

namespace {

std::size_t pieces_of(const Shape& shape) {
  if (const auto* mesh = std::get_if<TriangleMesh>(&shape)) return measure(*mesh).components;
  const std::vector<Contour>& contours = std::get<ContourSlice>(shape).contours;
  return static_cast<std::size_t>(std::count_if(contours.begin(), contours.end(),
                                                [](const Contour& contour) { return signed_area_mm2(contour) > 0; }));
}

}  // namespace

FrameComponents frame_components(const std::vector<Shape>& frames, const std::vector<KeyShape>& key_shapes) {
  FrameComponents result;
  for (const KeyShape& key : key_shapes) result.most_given = std::max(result.most_given, pieces_of(key.shape));
  for (std::size_t i = 0; i < frames.size(); ++i) {
    result.counts.push_back(pieces_of(frames[i]));
    if (result.counts.back() > result.most_given) result.stray.push_back(i);
  }
  return result;
}

}  // namespace isostack
