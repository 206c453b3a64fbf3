#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "recon/functions/space_time.h"
#include "recon/geometry/progress.h"
#include "recon/morphing/morph.h"
#include "recon/morphing/shape.h"

namespace isostack {

/// Where the first shape's half-cylinder ends and the second's begins.
enum class HalfCylinderEnds {
  smoothed,  ///< they taper off (Pasko et al. 2004, §4.1)
  flat       ///< cut by a plane (§3): most of the change happens at once, within the gap
};

/// A point of a key shape moves on its way to the next (§4.2, Figure 10).
struct KeyDeformation {
  std::size_t key = 0;                       ///< the shape that is left
  Eigen::VectorXd from_mm, to_mm;            ///< slice mm in the first figure's pose, or world mm
  double radius_mm = 0;                      ///< surroundings it takes along, at least 1.54 ways; 0: two ways
  TimeSpan during = {.from = 0, .to = 0.4};  ///< in shares of the way between the two shapes
};

struct BlendMorphOptions {
  HalfCylinderEnds ends = HalfCylinderEnds::smoothed;
  /// The blend's bounds, in shares of the way from one key shape to the next, within [0, 1]. Outside them frames are
  /// the key shapes, unless a deformation changes these.
  TimeSpan slab = {};
  std::optional<TimeSpan> gap = {};           ///< between the half-cylinders; unset: a 41st of the slab, in its middle
  std::optional<double> length_mm = {};       ///< from one key shape to the next; unset: the slab is 2.05 longest sides
  std::optional<BlendParameters> blend = {};  ///< unset: a1 = a2 = 2, a3 = 1, and a0 as `least_content` tells
  std::optional<BlendParameters> smoothing = {};  ///< unset: a0 is the shape's inradius, a1 = a2 = 0.7, a3 = 1
  std::optional<double> smoothing_reach_mm = {};  ///< unset: up to the slab's end
  /// Without `blend` a0 is the least for which no frame has less than this share of the smaller shape's area or volume.
  double least_content = 0.6;
  /// Of space-time (shape's coordinates, and mm from the first of two shapes): the blend stays within it, too.
  SolidFunction bounds = {};
  std::vector<KeyDeformation> deformations = {};
  /// Of the frames: lattice of figures, cells of bodies. 0: a pixel, or a hundredth of the box's longest side.
  double resolution_mm = 0;
};

/// Bounded space-time blending (Pasko, Pasko & Kunii 2004): each two neighbouring key shapes on the line of times are
/// half-cylinders of space-time, k + 1 dimensions, joined by a bounded blending union; frames are its sections. Key
/// shapes need not overlap nor have the same topology. They are functions by their exact signed distances.
/// Throws InputError for shapes that do not fit together, and for slabs, bounds and deformations that cannot be.
Morph blend_morph(const std::vector<KeyShape>& shapes, const BlendMorphOptions& options, const Progress& progress = {});

}  // namespace isostack
