#include "recon/morphing/signed_distance_stack.h"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "recon/geometry/errors.h"
#include "recon/metrics/contour_distance.h"

namespace isostack {

namespace {

/// Order of the slices along the lattice's normal.
std::vector<std::size_t> order_along(const std::vector<double>& positions_mm) {
  std::vector<std::size_t> order(positions_mm.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return positions_mm[a] < positions_mm[b]; });
  return order;
}

void require_stack(const ContourStack& contours, const PixelLattice& lattice) {
  const std::string name = contours.name.empty() ? "contours" : contours.name;
  if (contours.slices.size() < 2)
    throw GeometryError(name, "interpolation between slices needs at least two", "give more slices");
  for (const ContourSlice& slice : contours.slices)
    if (!are_parallel(slice.pose, lattice.pose))
      throw GeometryError(slice.name, "it is not parallel to the other slices",
                          "interpolate along the normal of parallel slices only");
  if (point_count(contours) == 0) throw GeometryError(name, "no slice has a contour", "check the level or label");
}

void fill_empty_slices(SignedDistanceStack& stack) {
  const std::vector<Image<float>> given = stack.distances_mm;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given[i].size() > 0) continue;
    std::size_t nearest = given.size();
    const auto gap_to = [&](std::size_t j) { return std::abs(stack.positions_mm[j] - stack.positions_mm[i]); };
    for (std::size_t j = 0; j < given.size(); ++j)
      if (given[j].size() > 0 && (nearest == given.size() || gap_to(j) < gap_to(nearest))) nearest = j;
    const auto half_gap = static_cast<float>(gap_to(nearest) / 2);
    stack.distances_mm[i] = -(half_gap * half_gap + given[nearest].cwiseMin(0.0f).square()).sqrt();
  }
}

/// The curvature part of the natural cubic spline: its second derivatives M solve T M = R y, and the value takes
/// lower · M_i + upper · M_(i+1). Returns Rᵀ T⁻¹ (lower e_i + upper e_(i+1)).
Eigen::VectorXd curvature_weights(const std::vector<double>& x, std::size_t interval, double lower, double upper) {
  const auto count = static_cast<Eigen::Index>(x.size());
  Eigen::SparseMatrix<double> t(count, count), r(count, count);
  std::vector<Eigen::Triplet<double>> t_entries = {{0, 0, 1.0},
                                                   {static_cast<int>(count) - 1, static_cast<int>(count) - 1, 1.0}};
  std::vector<Eigen::Triplet<double>> r_entries;
  for (int i = 1; i + 1 < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double before = x[at] - x[at - 1], after = x[at + 1] - x[at];
    t_entries.emplace_back(i, i, (before + after) / 3);
    if (i > 1) t_entries.emplace_back(i, i - 1, before / 6);  // the ends' second derivatives are 0
    if (i + 2 < count) t_entries.emplace_back(i, i + 1, after / 6);
    r_entries.emplace_back(i, i - 1, 1 / before);
    r_entries.emplace_back(i, i, -1 / before - 1 / after);
    r_entries.emplace_back(i, i + 1, 1 / after);
  }
  t.setFromTriplets(t_entries.begin(), t_entries.end());
  r.setFromTriplets(r_entries.begin(), r_entries.end());
  Eigen::VectorXd taken = Eigen::VectorXd::Zero(count);
  taken[static_cast<Eigen::Index>(interval)] = lower;
  taken[static_cast<Eigen::Index>(interval) + 1] = upper;
  return r.transpose() * Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(t).solve(taken);
}

}  // namespace

Image<float> signed_distance_image(const std::vector<Contour>& contours, const SlicePose& contours_pose,
                                   const PixelLattice& lattice) {
  const Eigen::Vector2i size = lattice.size_pixels;
  const Image<std::uint8_t> inside = pixels_inside(contours, contours_pose, lattice);
  const ContourDistance distance(moved_to(lattice.pose, contours, contours_pose));
  Image<float> image(size.y(), size.x());
  tbb::parallel_for(0, size.y(), [&](int row) {
    for (int column = 0; column < size.x(); ++column) {
      const double mm = distance.to(lattice.pose.pixel_to_slice({column, row}));
      image(row, column) = static_cast<float>(inside(row, column) != 0 ? mm : -mm);
    }
  });
  return image;
}

SignedDistanceStack signed_distance_stack(const ContourStack& contours, const PixelLattice& lattice) {
  require_stack(contours, lattice);
  std::vector<double> positions_mm;
  for (const ContourSlice& slice : contours.slices)
    positions_mm.push_back(lattice.pose.signed_distance_mm(slice.pose.origin_mm));
  SignedDistanceStack stack{.lattice = lattice, .positions_mm = {}, .distances_mm = {}};
  for (const std::size_t i : order_along(positions_mm)) {
    const ContourSlice& slice = contours.slices[i];
    if (!stack.positions_mm.empty() && positions_mm[i] - stack.positions_mm.back() < 1e-6)
      throw GeometryError(slice.name, "another slice lies at the same position", "leave one of them out");
    stack.positions_mm.push_back(positions_mm[i]);
    stack.distances_mm.push_back(slice.contours.empty() ? Image<float>()
                                                        : signed_distance_image(slice.contours, slice.pose, lattice));
  }
  fill_empty_slices(stack);
  return stack;
}

Eigen::VectorXd weights_along(const std::vector<double>& x, double at_mm, AlongNormal how) {
  const double at = std::clamp(at_mm, x.front(), x.back());
  const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, at);
  const auto interval = static_cast<std::size_t>(above - x.begin()) - 1;
  const double gap = x[interval + 1] - x[interval];
  const double upper = (at - x[interval]) / gap, lower = 1 - upper;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(x.size()));
  weights[static_cast<Eigen::Index>(interval)] = lower;
  weights[static_cast<Eigen::Index>(interval) + 1] = upper;
  if (how == AlongNormal::linear || x.size() < 3) return weights;
  const auto bend = [&](double share) { return (share * share * share - share) * gap * gap / 6; };
  return weights + curvature_weights(x, interval, bend(lower), bend(upper));
}

Image<float> interpolate(const SignedDistanceStack& stack, double at_mm, AlongNormal how) {
  const Eigen::VectorXd weights = weights_along(stack.positions_mm, at_mm, how);
  Image<float> sum = Image<float>::Zero(stack.lattice.size_pixels.y(), stack.lattice.size_pixels.x());
  for (std::size_t i = 0; i < stack.distances_mm.size(); ++i)
    if (const double weight = weights[static_cast<Eigen::Index>(i)]; weight != 0)
      sum += static_cast<float>(weight) * stack.distances_mm[i];
  return sum;
}

}  // namespace isostack
