#include "recon/constraints/thin_between.h"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "recon/constraints/parallel_neighbours.h"
#include "recon/constraints/plane_lines.h"
#include "recon/geometry/pixel_lattice.h"
#include "recon/metrics/contour_distance.h"

namespace isostack {

namespace {

constexpr int nodes_per_pixel = 2;  // a sheet's crest lies between pixel centres

using Distances = Image<float>;  // mm, positive inside; infinite (either sign) where farther than needed

/// Two parallel slices with contours and the lower one's pixels around them.
struct Gap {
  const ContourSlice &below, &above;
  double height_mm;
  PixelLattice lattice;
};

/// Nodes half a pixel of the lower slice apart, over the contours of both; those above are given in its frame.
PixelLattice lattice_over(const ContourSlice& below, const std::vector<Contour>& above) {
  PixelLattice lattice{below.pose, {}};
  lattice.pose.spacing_mm /= nodes_per_pixel;
  Eigen::AlignedBox2d box;
  for (const std::vector<Contour>* contours : {&below.contours, &above})
    for (const Contour& contour : *contours)
      for (const Eigen::Vector2d& p : contour.points_mm) box.extend(lattice.pose.slice_to_pixel(p));
  const Eigen::Vector2d first = box.min().array().floor() - 2.0;
  lattice.size_pixels = (box.max() - first).array().ceil().cast<int>() + 2 * nodes_per_pixel + 2;
  lattice.pose.origin_mm = lattice.pose.pixel_to_world(first);
  return lattice;
}

/// Signed distances to contours that are given in the lattice's frame. Blocks of pixels that are all farther than
/// `reach_mm` are not worked out.
Distances distances_within(const std::vector<Contour>& contours, const PixelLattice& lattice, double reach_mm) {
  constexpr int block = 8 * nodes_per_pixel;
  const Eigen::Vector2i size = lattice.size_pixels;
  const Image<std::uint8_t> inside = pixels_inside(contours, lattice.pose, lattice);
  const ContourDistance distance(contours);
  const double half_block_mm = block / std::sqrt(2.0) * lattice.pose.spacing_mm.maxCoeff();
  Distances image(size.y(), size.x());
  tbb::parallel_for(0, (size.y() + block - 1) / block, [&](int block_row) {
    for (int left = 0; left < size.x(); left += block) {
      const int top = block * block_row;
      const Eigen::Vector2d centre(left + block / 2, top + block / 2);
      const bool is_far = distance.to(lattice.pose.pixel_to_slice(centre)) > reach_mm + half_block_mm;
      for (int row = top; row < std::min(top + block, size.y()); ++row)
        for (int column = left; column < std::min(left + block, size.x()); ++column) {
          const auto mm = is_far ? std::numeric_limits<float>::infinity()
                                 : static_cast<float>(distance.to(lattice.pose.pixel_to_slice({column, row})));
          image(row, column) = inside(row, column) != 0 ? mm : -mm;
        }
    }
  });
  return image;
}

using Node = Eigen::Vector2i;  // column, row
using Step = Eigen::Vector2i;

/// A node in the middle of what both slices show, and the direction across.
struct Crest {
  Node node;
  Step across;
};

float at(const Distances& distances, const Node& node) { return distances(node.y(), node.x()); }

bool holds(const Distances& distances, const Node& node) {
  return node.x() >= 0 && node.y() >= 0 && node.x() < distances.cols() && node.y() < distances.rows();
}

/// The steepest of the four directions in which neither neighbour is larger; none where there is no such.
std::optional<Step> across_crest(const Distances& value, const Node& node) {
  const std::array<Step, 4> directions = {Step(1, 0), Step(0, 1), Step(1, 1), Step(1, -1)};
  std::optional<Step> across;
  float steepest = 0;
  for (const Step& step : directions) {
    const float drop_before = at(value, node) - at(value, node - step),
                drop_after = at(value, node) - at(value, node + step);
    const float drop = (drop_before + drop_after) / step.cast<float>().norm();
    if (drop_before < 0 || drop_after < 0 || !(drop > steepest)) continue;
    steepest = drop;
    across = step;
  }
  return across;
}

/// Crests of what both slices show, the highest of every two by two pixels.
std::vector<Crest> crests_of(const Distances& overlap, float least_mm, float most_mm) {
  constexpr int block = 2 * nodes_per_pixel;
  std::vector<Crest> crests;
  for (int top = 1; top + block < overlap.rows(); top += block)
    for (int left = 1; left + block < overlap.cols(); left += block) {
      float highest = least_mm;
      std::optional<Crest> crest;
      for (int row = top; row < top + block; ++row)
        for (int column = left; column < left + block; ++column) {
          const Node node(column, row);
          if (at(overlap, node) <= highest || at(overlap, node) >= most_mm) continue;
          const std::optional<Step> across = across_crest(overlap, node);
          if (!across) continue;
          highest = at(overlap, node);
          crest = Crest{node, *across};
        }
      if (crest) crests.push_back(*crest);
    }
  return crests;
}

/// The first node beside the crest that both slices show as outside, by `clear_mm`; none within four pixels.
std::optional<Node> beside(const Crest& crest, int sign, const Distances& reach, float clear_mm) {
  for (int steps = 1; steps <= 4 * nodes_per_pixel; ++steps) {
    const Node node = crest.node + sign * steps * crest.across;
    if (!holds(reach, node)) return {};
    if (at(reach, node) <= -clear_mm) return node;
  }
  return {};
}

/// The places on, and beside, the crests at all heights.
void add_places(const Gap& gap, std::size_t slice, const Distances& below, const Distances& above,
                const ThinBetweenOptions& options, std::vector<ThinPlace>& places) {
  const double pixel_mm = gap.below.pose.spacing_mm.minCoeff();
  const Distances overlap = below.cwiseMin(above), reach = below.cwiseMax(above);
  std::vector<Node> nodes;
  for (const Crest& crest : crests_of(overlap, static_cast<float>(options.least_overlap_pixels * pixel_mm),
                                      static_cast<float>(gap.height_mm / 2))) {
    nodes.push_back(crest.node);
    for (const int sign : {-1, 1})
      if (const auto node = beside(crest, sign, reach, static_cast<float>(options.clear_pixels * pixel_mm)))
        nodes.push_back(*node);
  }
  const int parts = std::max(2, static_cast<int>(std::ceil(gap.height_mm / pixel_mm / options.step_pixels)));
  for (int part = 1; part < parts; ++part) {
    const double t = static_cast<double>(part) / parts;
    const Eigen::Vector3d up = t * gap.height_mm * gap.lattice.pose.normal();
    for (const Node& node : nodes) {
      const double distance_mm = (1 - t) * at(below, node) + t * at(above, node);
      if (std::isfinite(distance_mm))
        places.push_back({slice, gap.lattice.pose.pixel_to_world(node.cast<double>()) + up, distance_mm});
    }
  }
}

}  // namespace

std::vector<ThinPlace> thin_between(const ContourStack& stack, const ThinBetweenOptions& options) {
  std::vector<ThinPlace> places;
  for (std::size_t s = 0; s < stack.slices.size(); ++s) {
    const ContourSlice& below = stack.slices[s];
    const std::optional<ParallelNeighbour> next = next_along_normal(stack, s);
    if (below.contours.empty() || !next || stack.slices[next->slice].contours.empty()) continue;
    const double gap_pixels = next->height_mm / below.pose.spacing_mm.minCoeff();
    if (gap_pixels <= options.least_gap_pixels) continue;
    const ContourSlice& above = stack.slices[next->slice];
    const Gap gap{below, above, next->height_mm, lattice_over(below, moved_to(below.pose, above.contours, above.pose))};
    const double reach_mm = next->height_mm / 2;
    const auto seen_from_below = [&](const ContourSlice& slice) {
      return distances_within(moved_to(gap.lattice.pose, slice.contours, slice.pose), gap.lattice, reach_mm);
    };
    const Distances from = seen_from_below(below), to = seen_from_below(above);
    add_places(gap, s, from, to, options, places);
  }
  return places;
}

}  // namespace isostack
