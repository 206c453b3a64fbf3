#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/morphing/level_set_morph.h"
#include "recon/morphing/unshared_parts.h"
#include "segmentation/field.h"

namespace isostack {

/// γ_B = f(d_B), f(0) = 0 and f′(0) = 1, at a distance in mm.
double approach_speed(ApproachProfile profile, double width_mm, double distance_mm);

/// One shape becoming another on a lattice of nodes: φ_t = |∇φ| γ_B (Breen et al. 2001, eq. 19). Keeps the two
/// distances and the course of the evolution; fields in between are found by going through it again, so that they do
/// not depend on which of them are asked for.
template <int D>
class LevelSetRun {
 public:
  /// Signed distances in mm, positive inside, on one lattice.
  LevelSetRun(Field<D> start, Field<D> target);

  const Field<D>& start() const { return start_; }
  const Field<D>& target() const { return target_; }
  /// Whether some node is inside both.
  bool overlaps() const { return overlaps_; }
  const std::vector<UnsharedRegion>& unshared() const { return unshared_; }
  /// Before the run: puts a small ball of the missing kind at the deepest node of each unshared region.
  void seed_unshared();

  /// Evolves to the end and keeps the course. Throws SolveError when nothing of the shape is left.
  void run(const LevelSetMorphOptions& options, const Progress& progress);
  const LevelSetCourse& course() const { return course_; }

  /// After the run: see(i, φ) for each of these shares of the way, in [0, 1], ascending. φ is a distance next to its
  /// zero set only.
  using See = std::function<void(std::size_t index, const Field<D>& phi)>;
  void fields_at(const std::vector<double>& shares, const Progress& progress, const See& see) const;

 private:
  Field<D> start_, target_;
  std::vector<UnsharedRegion> unshared_;
  bool overlaps_ = false, seeded_ = false;
  LevelSetMorphOptions options_;
  LevelSetCourse course_;
};

extern template class LevelSetRun<2>;
extern template class LevelSetRun<3>;

}  // namespace isostack
