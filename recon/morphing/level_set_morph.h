#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/morphing/morph.h"
#include "recon/morphing/shape.h"
#include "recon/morphing/shape_transform.h"
#include "recon/morphing/warp.h"

namespace isostack {

/// γ_B, the speed at a place, as a function of d_B, the signed distance to the target there.
enum class ApproachProfile {
  identity,  ///< d_B: all distances shrink at the same rate
  clamped,   ///< d_B within ± the width: far parts all move at one speed
  tanh       ///< width · tanh(d_B / width)
};

/// What goes evenly along the sequence from one key shape to the next.
enum class FramePacing {
  time,             ///< the evolution's own, in which distances shrink by e per unit
  volume_fraction,  ///< the share, behind it, of the area or volume that lies in just one of the two shapes
  rms_distance      ///< root mean square distance of the frame's boundary to the target
};

/// What to do about parts of a key shape where the one before it has nothing.
enum class UnsharedParts {
  leave,  ///< they stay missing: hollows stay filled
  seed    ///< a ball, at most three pixels wide, is put into each, and grows from there
};

/// Lengths in pixels are in units of the resolution.
struct LevelSetMorphOptions {
  ApproachProfile profile = ApproachProfile::identity;
  double width_pixels = 4;  ///< of the profiles clamped and tanh
  FramePacing pacing = FramePacing::volume_fraction;
  /// T of each key shape and the next; by landmarks when there are any (of two key shapes), else by moments.
  TransformKind transform = TransformKind::none;
  std::vector<LandmarkPair> landmarks = {};
  UnsharedParts unshared = UnsharedParts::leave;
  /// An evolution ends when the RMS distance of the boundary to the target is below this, nowhere above half a pixel,
  /// and every node deeper than half a pixel within reach is on the right side.
  double stop_rms_pixels = 0.1;
  int max_steps = 5000;  ///< of an evolution, at most
  /// Of the nodes. 0: a pixel, or a hundredth of the box's longest side.
  double resolution_mm = 0;
  std::size_t memory_limit_bytes = std::size_t{4} << 30;
};

/// A part of key shape `to` that `from` does not overlap, or a hollow of `to` that `from` fills.
struct UnsharedPart {
  std::string from, to;
  bool is_hollow = false;
  Eigen::Vector3d place_mm;  ///< its innermost point, world
  double content = 0;        ///< mm² or mm³
};

/// Where an evolution is after a step.
struct LevelSetStep {
  double time = 0;
  double shared_fraction = 0;   ///< of the target's area or volume; never falls
  double matched_fraction = 0;  ///< of what lay in one of the two shapes only, how much is as in the target; the same
  double rms_mm = 0;            ///< RMS distance of the boundary to the target's
  double largest_mm = 0;        ///< the largest such distance
};

/// An evolution from one key shape to the next.
struct LevelSetCourse {
  std::string from, to;
  std::vector<LevelSetStep> steps;  ///< the first is before any step
  bool arrived = false;             ///< false: it stopped at the limit of steps, or where it did not move any more
};

/// From one key shape to the next; for implementations.
class LevelSetLeg;

/// A morph ready to run: distances are known and the shapes compared.
struct LevelSetPlan {
  std::vector<UnsharedPart> unshared;  ///< with UnsharedParts::seed too
  std::vector<std::shared_ptr<LevelSetLeg>> legs;
  KeyPlaces places;
  MorphReport report;
};

struct LevelSetMorph {
  Morph morph;
  std::vector<LevelSetCourse> courses;  ///< one from each key shape to the next
};

/// Key shapes lie on a line, each becomes the next: A → B → C → A is four. Throws InputError for shapes that do not fit
/// together or overlap nowhere (unless seeded), SolveError when the nodes do not fit into memory.
LevelSetPlan plan_level_set_morph(const std::vector<KeyShape>& shapes, const LevelSetMorphOptions& options,
                                  const Progress& progress = {});

/// Runs all evolutions. The plan is used up.
LevelSetMorph run_level_set_morph(LevelSetPlan plan, const Progress& progress = {});

/// Breen & Whitaker 2001, §5: each shape moves along its normals at the speed γ_B, which makes it share more and more
/// volume with the next: φ_t = |∇φ| γ_B, in the coordinates of the former, where B is T(x, 1)⁻¹ of the next. Frames are
/// the zero set moved by T(x, α), α along the way from 0 to 1. What grows stays within the next shape, what shrinks
/// around it; frames lie between the two. Frames asked for together need one more evolution of each pair they are
/// between. The result is the same on any number of threads.
Morph level_set_morph(const std::vector<KeyShape>& shapes, const LevelSetMorphOptions& options,
                      const Progress& progress = {});

}  // namespace isostack
