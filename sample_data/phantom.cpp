#include "sample_data/phantom.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace isostack {

namespace {

const Eigen::Vector3d centre_mm(-22, 14, 118);  // away from the world's origin, so that lost offsets show

/// A capsule whose radius changes linearly along its axis; relative to centre_mm.
struct Limb {
  Eigen::Vector3d from_mm;
  Eigen::Vector3d to_mm;
  double from_radius_mm;
  double to_radius_mm;
};

const std::array<Limb, 6> limbs = {{
    {{2, 4, -40}, {0, 0, -8}, 9, 15},      // trunk
    {{0, 0, -8}, {-26, -3, 10}, 15, 12},   // right branch, bent once
    {{-26, -3, 10}, {-34, 2, 36}, 12, 7},  //
    {{0, 0, -8}, {30, -6, 22}, 13, 8},     // left branch
    {{0, 0, -4}, {3, 28, 26}, 11, 7},      // back branch
    {{4, -2, 0}, {2, -22, 36}, 9, 6},      // front branch
}};

double limb_distance_mm(const Limb& limb, const Eigen::Vector3d& p) {
  const Eigen::Vector3d axis = limb.to_mm - limb.from_mm;
  const double t = std::clamp((p - limb.from_mm).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
  return std::lerp(limb.from_radius_mm, limb.to_radius_mm, t) - (p - limb.from_mm - t * axis).norm();
}

/// Union of two fields that are positive inside, rounded where they differ by less than `blend_mm`.
double smooth_union(double a, double b, double blend_mm) {
  const double overlap = std::max(blend_mm - std::abs(a - b), 0.0) / blend_mm;
  return std::max(a, b) + overlap * overlap * blend_mm / 4;
}

}  // namespace

double phantom_distance_mm(const Eigen::Vector3d& point_in_world_mm) {
  const Eigen::Vector3d p = point_in_world_mm - centre_mm;
  double inside = limb_distance_mm(limbs.front(), p);
  for (std::size_t i = 1; i < limbs.size(); ++i) inside = smooth_union(inside, limb_distance_mm(limbs[i], p), 9);
  const double dent = 11 - (p - Eigen::Vector3d(8, -19, -16)).norm();
  return -smooth_union(-inside, dent, 4);
}

Eigen::AlignedBox3d phantom_bounds_mm() {
  Eigen::AlignedBox3d box;
  for (const Limb& limb : limbs) {
    constexpr double spare_mm = 6;  // the smooth union bulges beyond its parts
    box.extend(Eigen::AlignedBox3d(limb.from_mm.array() - limb.from_radius_mm - spare_mm,
                                   limb.from_mm.array() + limb.from_radius_mm + spare_mm));
    box.extend(Eigen::AlignedBox3d(limb.to_mm.array() - limb.to_radius_mm - spare_mm,
                                   limb.to_mm.array() + limb.to_radius_mm + spare_mm));
  }
  return box.translate(centre_mm);
}

Slice render_phantom_slice(const SlicePose& pose, const Eigen::Vector2i& size_pixels, const PhantomImaging& imaging) {
  // An edge blurred by a Gaussian of deviation s rises from 10 % to 90 % within 2.56 s.
  const double deviation_mm = std::max(imaging.blur_pixels * pose.spacing_mm.mean() / 2.56, 1e-9);
  std::mt19937_64 random(imaging.seed);
  std::normal_distribution<double> noise_hu(0, std::max(imaging.noise_hu, 1e-9));
  Slice slice{.name = "phantom", .pose = pose, .pixels = Image<float>(size_pixels.y(), size_pixels.x())};
  for (Eigen::Index row = 0; row < slice.pixels.rows(); ++row)
    for (Eigen::Index column = 0; column < slice.pixels.cols(); ++column) {
      const Eigen::Vector2d pixel(static_cast<double>(column), static_cast<double>(row));
      const double distance_mm = phantom_distance_mm(pose.pixel_to_world(pixel));
      const double organ_share = std::erfc(-distance_mm / (deviation_mm * std::sqrt(2.0))) / 2;
      const double hu = std::lerp(imaging.background_hu, imaging.organ_hu, organ_share) + noise_hu(random);
      slice.pixels(row, column) = static_cast<float>(hu);
    }
  return slice;
}

}  // namespace isostack
