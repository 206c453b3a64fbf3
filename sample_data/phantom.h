#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>

#include "recon/geometry/slice.h"

namespace isostack {

/// An organ with a closed form: a trunk that forks into four branches of different thickness, smoothly joined, with a
/// dent in its side. Some 95 mm large, connected, without tunnels.
///
/// Signed-distance-like implicit function, positive inside, of a point in world LPS mm: zero on the surface, its
/// gradient about 1 near it, down to 0.5 where branches fork.
double phantom_distance_mm(const Eigen::Vector3d& point_in_world_mm);

/// A world-aligned box that contains the phantom with some millimetres to spare.
Eigen::AlignedBox3d phantom_bounds_mm();

/// How the phantom is imaged. Defaults resemble contrast-enhanced CT, in Hounsfield units.
struct PhantomImaging {
  double organ_hu = 100;
  double background_hu = -50;
  double blur_pixels = 1;  ///< width (10 % to 90 %) of the blurred edge, in pixels
  double noise_hu = 15;    ///< standard deviation of the Gaussian noise
  std::uint64_t seed = 1;  ///< the same seed gives the same pixels

  /// The grey value on the surface itself: half way, as the blur is symmetric.
  double level_hu() const { return (organ_hu + background_hu) / 2; }
};

/// The phantom cut by a plane: `size_pixels` = columns, rows.
Slice render_phantom_slice(const SlicePose& pose, const Eigen::Vector2i& size_pixels,
                           const PhantomImaging& imaging = {});

}  // namespace isostack
