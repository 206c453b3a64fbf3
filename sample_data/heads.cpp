#include "sample_data/heads.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace isostack {

namespace {

using Eigen::Vector3d;

/// Positive inside, about the distance near the surface.
double ellipsoid(const Vector3d& p, const Vector3d& centre, const Vector3d& radii) {
  return (1 - (p - centre).cwiseQuotient(radii).norm()) * radii.minCoeff();
}

/// max(a, b) with its crease rounded over this length.
double smooth_max(double a, double b, double over_mm) {
  const double near = std::max(over_mm - std::abs(a - b), 0.0) / over_mm;
  return std::max(a, b) + near * near * over_mm / 4;
}

/// x from the middle: the heads are symmetric.
Vector3d one_side(Vector3d p) {
  p.x() = std::abs(p.x());
  return p;
}

double modelled_depth(const Vector3d& point) {
  const Vector3d p = one_side(point);
  double depth = ellipsoid(p, {0, 12, 92}, {70, 90, 76});                    // cranium
  depth = smooth_max(depth, ellipsoid(p, {0, -34, 42}, {52, 54, 66}), 18);   // face
  depth = smooth_max(depth, ellipsoid(p, {0, 22, -6}, {46, 48, 62}), 14);    // neck
  depth = smooth_max(depth, ellipsoid(p, {0, -68, -4}, {24, 22, 18}), 14);   // chin
  depth = smooth_max(depth, ellipsoid(p, {0, -94, 54}, {11, 18, 18}), 8);    // nose
  depth = smooth_max(depth, ellipsoid(p, {72, 14, 62}, {7, 17, 26}), 4);     // ears
  return -smooth_max(-depth, ellipsoid(p, {26, -92, 76}, {15, 22, 11}), 6);  // eye sockets
}

struct Scanned {
  double skin, bone_outside, bone_inside, cavity;
};

Scanned scanned_depths(const Vector3d& point) {
  const Vector3d p = one_side(point);
  const double cranium = ellipsoid(p, {0, 8, 84}, {64, 100, 84});
  const double face = ellipsoid(p, {0, -40, 40}, {56, 52, 58});
  Scanned depths{};
  depths.skin = smooth_max(smooth_max(cranium, face, 16), ellipsoid(p, {0, 30, -10}, {56, 52, 70}), 20);
  depths.skin = smooth_max(depths.skin, ellipsoid(p, {0, -62, -6}, {30, 22, 22}), 12);
  depths.skin = smooth_max(depths.skin, ellipsoid(p, {0, -96, 46}, {14, 22, 14}), 6);
  depths.skin = smooth_max(depths.skin, ellipsoid(p, {67, 18, 54}, {9, 13, 32}), 4);
  depths.skin = -smooth_max(-depths.skin, ellipsoid(p, {28, -94, 66}, {13, 18, 9}), 6);
  depths.bone_outside = std::max(cranium, face) - 7;
  depths.bone_inside = cranium - 14;
  depths.cavity = ellipsoid(p, {0, -56, 38}, {12, 22, 20});
  return depths;
}

}  // namespace

Body modelled_head() { return {"head", 0, modelled_depth}; }

std::string solid_head_json() {
  return R"({
  "format": "isostack-solid",
  "version": 1,
  "solid": {"name": "head", "difference": [
    {"union": [
      {"name": "cranium", "superellipsoid": {"radii_mm": [66, 92, 62], "exponents": [0.6, 0.8]},
       "affine": [[1, 0, 0, 0], [0, 1, 0, 10], [0, 0, 1, 106]]},
      {"name": "face", "superellipsoid": {"radii_mm": [50, 44, 66], "exponents": [0.5, 0.6]},
       "affine": [[1, 0, 0, 0], [0, 1, 0, -44], [0, 0, 1, 50]]},
      {"name": "neck", "superellipsoid": {"radii_mm": [42, 42, 60], "exponents": [0.2, 1]},
       "affine": [[1, 0, 0, 0], [0, 1, -0.2, 26], [0, 0, 1, 0]]},
      {"name": "nose", "superellipsoid": {"radii_mm": [12, 24, 24], "exponents": [1.4, 1.2]},
       "affine": [[1, 0, 0, 0], [0, 1, 0.3, -90], [0, 0, 1, 60]]},
      {"name": "left ear", "superellipsoid": {"radii_mm": [8, 22, 28], "exponents": [1, 0.6]},
       "affine": [[1, 0, 0, 70], [0, 1, 0, 10], [0, 0, 1, 70]]},
      {"name": "right ear", "superellipsoid": {"radii_mm": [8, 22, 28], "exponents": [1, 0.6]},
       "affine": [[1, 0, 0, -70], [0, 1, 0, 10], [0, 0, 1, 70]]}]},
    {"name": "left eye", "superellipsoid": {"radii_mm": [14, 16, 9], "exponents": [0.7, 1]},
     "affine": [[1, 0, 0, 25], [0, 1, 0, -88], [0, 0, 1, 86]]},
    {"name": "right eye", "superellipsoid": {"radii_mm": [14, 16, 9], "exponents": [0.7, 1]},
     "affine": [[1, 0, 0, -25], [0, 1, 0, -88], [0, 0, 1, 86]]},
    {"name": "mouth", "superellipsoid": {"radii_mm": [26, 14, 6], "exponents": [0.4, 1]},
     "affine": [[1, 0, 0, 0], [0, 1, 0, -88], [0, 0, 1, 20]]}
  ]}
}
)";
}

Volume<float> scanned_head() {
  constexpr double voxel_mm = 2.5;
  Grid grid;
  grid.size = {70, 100, 102};
  grid.index_to_world.linear() *= voxel_mm;
  grid.index_to_world.translation() = Vector3d(-0.5 * voxel_mm * 69, -134, -80);
  Volume<float> scan(grid);
  std::mt19937_64 random(1);
  // Share of a voxel on the inner side of a surface at this depth.
  const auto share = [&](double depth_mm) { return std::clamp(0.5 + depth_mm / voxel_mm, 0.0, 1.0); };
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Scanned depths = scanned_depths(grid.index_to_world * Vector3d(i, j, k));
        double hu = std::lerp(-1000, 40, share(depths.skin));
        hu = std::lerp(hu, 700, std::min(share(depths.bone_outside), share(depths.skin)));
        hu = std::lerp(hu, 40, share(depths.bone_inside));
        hu = std::lerp(hu, -1000, share(depths.cavity));
        // A sum of dice: the same on every machine, which normal_distribution is not.
        double noise = -6;
        for (int n = 0; n < 12; ++n) noise += static_cast<double>(random() >> 11) * 0x1p-53;
        scan.at(i, j, k) = static_cast<float>(std::lround(hu + 25 * noise));
      }
  return scan;
}

}  // namespace isostack
