#pragma once

#include <cstddef>
#include <vector>

#include "recon/morphing/level_set_morph.h"
#include "recon/morphing/unshared_parts.h"
#include "segmentation/field.h"

namespace isostack {

/// How a shape on a lattice compares with the target, in nodes, kept up to date as nodes change sides.
template <int D>
class NodeCounts {
 public:
  /// Both are positive inside; `target` outlives this. What lies in `out_of_reach` is not waited for.
  NodeCounts(const Field<D>& start, const Field<D>& target, const std::vector<UnsharedRegion>& out_of_reach);

  void changed_side(std::size_t node, bool is_inside_now);
  double shared_fraction() const;
  double matched_fraction() const;
  /// Nodes on the wrong side deeper than half a pixel, within reach.
  long deep_and_wrong() const { return deep_and_wrong_; }
  std::size_t changes() const { return changes_; }

 private:
  bool is_deep(std::size_t node) const;

  const Field<D>& target_;
  long target_inside_ = 0, shared_ = 0, first_wrong_ = 0, wrong_ = 0, deep_and_wrong_ = 0;
  std::size_t changes_ = 0;
};

extern template class NodeCounts<2>;
extern template class NodeCounts<3>;

struct CurveDistance {
  double rms_mm = 0, largest_mm = 0;
};

/// Size of `distance` where the curve φ = 0 crosses the lattice's edges; 0 without a curve. `beside_curve`: nodes with
/// a neighbour on the other side.
template <int D>
CurveDistance distance_on_curve(const Field<D>& phi, const Field<D>& distance,
                                const std::vector<std::size_t>& beside_curve);

extern template CurveDistance distance_on_curve(const Field<2>&, const Field<2>&, const std::vector<std::size_t>&);
extern template CurveDistance distance_on_curve(const Field<3>&, const Field<3>&, const std::vector<std::size_t>&);

/// After a step, and how much of the next one is behind it, in [0, 1).
struct CoursePlace {
  std::size_t step = 0;
  double share = 0;
};

/// Where this share of the way, in [0, 1], is behind, as the pacing counts it. The whole course is 1.
CoursePlace place_on(const LevelSetCourse& course, FramePacing pacing, double share);

}  // namespace isostack
