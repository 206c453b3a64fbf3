#include "recon/morphing/interpolator_sections.h"

#include <utility>

namespace isostack {

InterpolatorSections::InterpolatorSections(SimplicialMesh mesh, Eigen::RowVectorXd key_times_mm,
                                           const Eigen::AlignedBox3d& box_mm, const TimeWarp& warp)
    : mesh_(std::move(mesh)), key_times_mm_(std::move(key_times_mm)) {
  const Eigen::Index t = mesh_.dimension() - 1;
  shown_ = (mesh_.vertices.row(t).array() - key_times_mm_[0]) / length_mm();
  if (!warp.is_set()) return;
  for (Eigen::Index v = 0; v < shown_.size(); ++v)
    shown_[v] = warp.shown_at(mesh_.vertices.col(v).head(t), box_mm, shown_[v]);
}

std::vector<Shape> InterpolatorSections::shapes_at(const std::vector<Eigen::VectorXd>& weights,
                                                   const Progress& progress) const {
  std::vector<Shape> shapes;
  for (const Eigen::VectorXd& weight : weights) {
    progress.report("frames", static_cast<double>(shapes.size()) / static_cast<double>(weights.size()));
    const double t = time_of(weight);
    shapes.push_back(section(shown_.array() - t, t > 0 ? OnSection::beyond : OnSection::before));
  }
  return shapes;
}

/// From 0 to 1; exactly a key shape's where rounding alone is between them.
double InterpolatorSections::time_of(const Eigen::VectorXd& weights) const {
  Eigen::Index nearest = 0;
  const bool is_key_shape = weights.maxCoeff(&nearest) > 1 - 1e-9;
  const double t_mm = is_key_shape ? key_times_mm_[nearest] : key_times_mm_.dot(weights);
  return (t_mm - key_times_mm_[0]) / length_mm();
}

}  // namespace isostack
