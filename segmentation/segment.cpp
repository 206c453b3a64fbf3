#include "segmentation/segment.h"

#include <cmath>
#include <limits>
#include <utility>

#include "recon/geometry/errors.h"
#include "segmentation/organs.h"

namespace isostack {

namespace {

void require(bool holds, const char* problem, const char* remedy) {
  if (!holds) throw InputError("segmentation options", problem, remedy);
}

void check(const SegmentationOptions& options) {
  require(std::isfinite(options.level), "the level is not a number", "give a grey value");
  require(options.gaussian_sigma_pixels >= 0 && std::isfinite(options.gaussian_sigma_pixels),
          "the Gaussian's sigma is negative or not a number", "give pixels, 0 for no filter");
}

}  // namespace

ContourStack segment(const SliceStack& stack, const SegmentationOptions& options, const Progress& progress) {
  check(options);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  OrganOptions organ;
  if (options.gaussian_sigma_pixels > 0) organ.start.push_back(GaussianStep{options.gaussian_sigma_pixels});
  organ.start.push_back(
      RangeStep{options.brighter_inside ? GreyRange{options.level, infinity} : GreyRange{-infinity, options.level}});
  if (options.fill_holes) organ.start.push_back(FillHolesStep{});
  if (options.largest) organ.start.push_back(LargestStep{});
  organ.evolution.curvature = options.curvature;
  organ.evolution.max_steps = options.max_steps;
  return std::move(segment_organs(stack, organ, progress).organs.front());
}

}  // namespace isostack
