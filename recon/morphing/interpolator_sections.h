#pragma once

#include <vector>

#include "recon/morphing/morph.h"
#include "recon/subdivision/simplex_section.h"
#include "recon/subdivision/simplicial_mesh.h"
#include "recon/subdivision/time_warp.h"

namespace isostack {

/// Morphs whose frames are sections of an optimised interpolator at t = const, or at the curved t of a time warp
/// (Ohbuchi et al. 2001, Sections 2.1 and 2.4.4).
class InterpolatorSections : public MorphMethod {
 public:
  std::vector<Shape> shapes_at(const std::vector<Eigen::VectorXd>& weights, const Progress& progress) const override;

 protected:
  /// The mesh's last coordinate is t in mm. `box_mm` holds the key shapes: the warp is relative to it.
  InterpolatorSections(SimplicialMesh mesh, Eigen::RowVectorXd key_times_mm, const Eigen::AlignedBox3d& box_mm,
                       const TimeWarp& warp);

  /// The frame where the values change sign.
  virtual Shape section(const Eigen::VectorXd& values, OnSection on) const = 0;

  const SimplicialMesh& mesh() const { return mesh_; }
  /// When a vertex is shown, mm.
  double shown_mm(Eigen::Index vertex) const { return key_times_mm_[0] + shown_[vertex] * length_mm(); }

 private:
  double length_mm() const { return key_times_mm_[key_times_mm_.size() - 1] - key_times_mm_[0]; }
  double time_of(const Eigen::VectorXd& weights) const;

  SimplicialMesh mesh_;
  Eigen::RowVectorXd key_times_mm_;
  Eigen::VectorXd shown_;  ///< at which share of the time each vertex is shown
};

}  // namespace isostack
