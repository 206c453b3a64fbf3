#include "recon/lost_contours.h"

#include <algorithm>
#include <map>
#include <utility>

#include "recon/surface/islands.h"

namespace isostack {

namespace {

/// Specks this small fit between the cells' corners; they are counted, not missed.
constexpr double speck_pixels = 2;

constexpr double near_widths = 2, far_widths = 8;  ///< of the boxes round a contour in which its part must be closed
constexpr int finest = 8;                          ///< cells of a part may be this much finer than the surface's

double width_mm(const LostContour& contour, const FittedOrgan& organ) {
  Eigen::AlignedBox2d box;
  for (const std::size_t seed : contour) box.extend(organ.samples[seed].point_in_slice_mm);
  return box.sizes().maxCoeff();
}

std::optional<TriangleMesh> part_at(const LostContour& contour, const FittedOrgan& organ, const ScalarField& field,
                                    const ExtractionOptions& extraction) {
  std::vector<Eigen::Vector3d> seeds_mm;
  Eigen::AlignedBox3d box;
  for (const std::size_t seed : contour) {
    seeds_mm.push_back(organ.seeds_mm[seed]);
    box.extend(organ.seeds_mm[seed]);
  }
  for (const double reach_mm : {near_widths * width_mm(contour, organ), far_widths * width_mm(contour, organ)}) {
    const Eigen::AlignedBox3d around(box.min().array() - reach_mm, box.max().array() + reach_mm);
    for (int finer = 2; finer <= finest; finer *= 2)
      if (auto part = extract_island(field, seeds_mm, around, extraction.resolution_mm / finer, extraction))
        return part;
  }
  return std::nullopt;
}

}  // namespace

std::vector<LostContour> lost_contours(const FittedOrgan& organ, const std::vector<std::size_t>& lost_seeds) {
  using Loop = std::pair<std::size_t, std::size_t>;
  const auto loop_of = [&](std::size_t seed) { return Loop{organ.samples[seed].slice, organ.samples[seed].contour}; };
  std::vector<LostContour> lost;
  if (organ.samples.empty()) return lost;
  std::map<Loop, LostContour> without_surface;
  for (const std::size_t seed : lost_seeds) without_surface[loop_of(seed)].push_back(seed);
  if (without_surface.empty()) return lost;
  std::map<Loop, std::size_t> samples_on;
  for (std::size_t seed = 0; seed < organ.samples.size(); ++seed) ++samples_on[loop_of(seed)];
  for (auto& [loop, seeds] : without_surface) {
    if (seeds.size() < samples_on[loop]) continue;
    const double speck_mm = speck_pixels * organ.poses[loop.first].spacing_mm.minCoeff();
    if (width_mm(seeds, organ) > speck_mm) lost.push_back(std::move(seeds));
  }
  return lost;
}

std::vector<LostContour> add_lost_parts(const std::vector<LostContour>& lost, const FittedOrgan& organ,
                                        const ScalarField& field, const ExtractionOptions& extraction,
                                        ExtractedSurface& extracted) {
  std::vector<LostContour> still_lost;
  std::vector<std::size_t> found;
  for (const LostContour& contour : lost) {
    const auto part = part_at(contour, organ, field, extraction);
    if (part && add_island(*part, extraction.resolution_mm, extracted.mesh))
      found.insert(found.end(), contour.begin(), contour.end());
    else
      still_lost.push_back(contour);
  }
  std::erase_if(extracted.seeds_without_surface,
                [&](std::size_t seed) { return std::find(found.begin(), found.end(), seed) != found.end(); });
  return still_lost;
}

}  // namespace isostack
