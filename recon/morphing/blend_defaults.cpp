#include "recon/morphing/blend_defaults.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

// Measured on overlapping and on disjoint figures: the smallest changes between frames without swelling.
constexpr double gap_share = 1 / 41.0;
constexpr BlendParameters default_blend{.a0 = 0, .a1 = 2, .a2 = 2, .a3 = 1};
constexpr BlendParameters default_smoothing{.a0 = 1, .a1 = 0.7, .a2 = 0.7, .a3 = 1};  // a0 in inradii

/// Points of the shapes' space with the area or volume each stands for.
struct Samples {
  Eigen::MatrixXd points;   ///< k × M
  Eigen::ArrayXd contents;  ///< M
};

constexpr double margin = 0.25;  // round both shapes, in longest sides
constexpr double own_margin = 0.05;

Eigen::AlignedBox3d widened(const Eigen::AlignedBox3d& box, double share, int dimension) {
  Eigen::Vector3d by = Eigen::Vector3d::Constant(share * box.sizes().maxCoeff());
  if (dimension == 2) by.z() = 0;
  return {box.min() - by, box.max() + by};
}

/// The middles of cubes that fill the box, of those that `counts` accepts.
template <class Counts>
void append_cells(const Eigen::AlignedBox3d& box, int dimension, const Counts& counts, Samples& samples) {
  const double cell_mm = box.sizes().maxCoeff() / (dimension == 2 ? 64 : 24);
  const Eigen::Array3i size = (box.sizes().array() / cell_mm).ceil().max(1).cast<int>();
  std::vector<Eigen::Vector3d> kept;
  for (int k = 0; k < (dimension == 2 ? 1 : size.z()); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i) {
        Eigen::Vector3d point = box.min() + cell_mm * (Eigen::Vector3d(i, j, k).array() + 0.5).matrix();
        if (dimension == 2) point.z() = box.min().z();
        if (counts(point)) kept.push_back(point);
      }
  const Eigen::Index before = samples.contents.size(), more = static_cast<Eigen::Index>(kept.size());
  samples.points.conservativeResize(dimension, before + more);
  samples.contents.conservativeResize(before + more);
  for (Eigen::Index i = 0; i < more; ++i)
    samples.points.col(before + i) = kept[static_cast<std::size_t>(i)].head(dimension);
  samples.contents.tail(more).setConstant(std::pow(cell_mm, dimension));
}

/// Fine within each shape's box, so that small shapes far apart are seen, and coarse round them.
Samples samples_of(const BoxedSolid& first, const BoxedSolid& second) {
  const int dimension = first.dimension;
  const Eigen::AlignedBox3d one = widened(first.box_mm, own_margin, dimension);
  const Eigen::AlignedBox3d two = widened(second.box_mm, own_margin, dimension);
  Samples samples;
  append_cells(
      one, dimension, [](const Eigen::Vector3d&) { return true; }, samples);
  append_cells(
      two, dimension, [&](const Eigen::Vector3d& p) { return !one.contains(p); }, samples);
  append_cells(
      widened(first.box_mm.merged(second.box_mm), margin, dimension), dimension,
      [&](const Eigen::Vector3d& p) { return !one.contains(p) && !two.contains(p); }, samples);
  return samples;
}

/// The least a0 for which the solid u + a0 d has this content.
double least_a0(const Eigen::ArrayXd& u, const Eigen::ArrayXd& d, const Eigen::ArrayXd& contents, double content) {
  const Eigen::ArrayXd needed = (u > 0).select(
      0, (d > 0).select(-u / d.max(std::numeric_limits<double>::min()), std::numeric_limits<double>::infinity()));
  std::vector<Eigen::Index> order(static_cast<std::size_t>(needed.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return needed[a] < needed[b]; });
  double sum = 0;
  for (const Eigen::Index i : order)
    if ((sum += contents[i]) >= content) return needed[i];
  return std::numeric_limits<double>::infinity();
}

/// The least a0 for which every frame keeps its content. The solids' values at the samples are taken once.
double a0_for(const Samples& samples, const Eigen::ArrayXd& first, const Eigen::ArrayXd& second, SpaceTimeBlend blend,
              double least_content) {
  const auto sampled = [](const Eigen::ArrayXd& values) {
    return SolidFunction([&values](const Eigen::MatrixXd&) { return values; });
  };
  const auto content_of = [&](const Eigen::ArrayXd& f) { return (f > 0).select(samples.contents, 0).sum(); };
  const double content = least_content * std::min(content_of(first), content_of(second));
  blend.blend.a0 = 0;
  const SolidFunction plain = space_time_blend(sampled(first), sampled(second), blend);
  blend.blend.a0 = 1;
  const SolidFunction blended = space_time_blend(sampled(first), sampled(second), blend);
  constexpr int times = 40;
  double a0 = 0;
  for (int i = 1; i < times; ++i) {
    const double time_mm = std::lerp(blend.slab_mm.from, blend.slab_mm.to, i / static_cast<double>(times));
    const Eigen::ArrayXd u = cross_section(plain, time_mm)(samples.points);
    const Eigen::ArrayXd d = cross_section(blended, time_mm)(samples.points) - u;
    a0 = std::max(a0, least_a0(u, d, samples.contents, content));
  }
  return a0;
}

TimeSpan scaled(const TimeSpan& span, double by) { return {.from = by * span.from, .to = by * span.to}; }

HalfCylinderSmoothing smoothing_of(const Eigen::ArrayXd& values, double reach_mm, const BlendMorphOptions& options) {
  HalfCylinderSmoothing smoothing{.blend = options.smoothing.value_or(default_smoothing),
                                  .reach_mm = options.smoothing_reach_mm.value_or(reach_mm)};
  if (!options.smoothing) smoothing.blend.a0 *= std::max(0.0, values.maxCoeff());
  return smoothing;
}

}  // namespace

SpaceTimeBlend blend_between(const BoxedSolid& first, const BoxedSolid& second, double length_mm,
                             const BlendMorphOptions& options) {
  const TimeSpan& slab = options.slab;
  if (!(slab.from >= 0 && slab.from < slab.to && slab.to <= 1))
    throw InputError("blend", fmt::format("a bounding slab from {:g} to {:g}", slab.from, slab.to),
                     "let it begin and end within 0 and 1, in this order");
  SpaceTimeBlend blend;
  blend.slab_mm = scaled(slab, length_mm);
  blend.bounds = options.bounds;
  const double middle = 0.5 * (slab.from + slab.to), half = 0.5 * gap_share * (slab.to - slab.from);
  blend.gap_mm = scaled(options.gap.value_or(TimeSpan{.from = middle - half, .to = middle + half}), length_mm);
  blend.blend = options.blend.value_or(default_blend);
  const Samples samples = samples_of(first, second);
  const Eigen::ArrayXd values1 = first.solid(samples.points), values2 = second.solid(samples.points);
  if (options.ends == HalfCylinderEnds::smoothed) {
    blend.first = smoothing_of(values1, blend.gap_mm.from - blend.slab_mm.from, options);
    blend.second = smoothing_of(values2, blend.slab_mm.to - blend.gap_mm.to, options);
  }
  if (!options.blend) blend.blend.a0 = a0_for(samples, values1, values2, blend, options.least_content);
  if (!std::isfinite(blend.blend.a0))
    throw InputError("blend", "within its bounds no added material fills the gap between the shapes",
                     "widen the bounds, or give the blend's parameters");
  return blend;
}

}  // namespace isostack
