#include "recon/reconstruct_all.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "recon/geometry/errors.h"
#include "recon/metrics/input_sections.h"
#include "recon/organ_surface.h"

namespace isostack {

namespace {

struct Organ {
  FittedOrgan fitted;
  BoundedField own;         ///< without regard to the others
  Eigen::AlignedBox3d box;  ///< of its surface, two cells wider
  std::vector<int> rivals;  ///< organs that overlap it
};

/// How far inside an organ points are, in terms of its function and its bounds; −∞ outside its surface's box.
Eigen::VectorXd values_within(const Organ& organ, const Eigen::Matrix3Xd& points) {
  Eigen::VectorXd values = Eigen::VectorXd::Constant(points.cols(), -std::numeric_limits<double>::infinity());
  std::vector<Eigen::Index> near;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (organ.box.contains(points.col(i))) near.push_back(i);
  if (near.empty()) return values;
  const Eigen::VectorXd f = organ.own.field.values(points(Eigen::all, near));
  for (std::size_t k = 0; k < near.size(); ++k) {
    double& value = values[near[k]];
    value = f[static_cast<Eigen::Index>(k)];
    for (const auto& half_space : organ.own.bounds.half_spaces)
      value = std::min(value, half_space.signedDistance(points.col(near[k])));
  }
  return values;
}

/// min(f_i, f_i − max_{j≠i} f_j) and the gradient of the branch that is active.
ScalarField without_rivals(const std::vector<Organ>& organs, const Organ& organ) {
  const auto strongest = [&organs, &organ](const Eigen::Matrix3Xd& points) {
    std::vector<int> winner(static_cast<std::size_t>(points.cols()), -1);
    Eigen::VectorXd value = Eigen::VectorXd::Zero(points.cols());
    for (const int rival : organ.rivals) {
      const Eigen::VectorXd other = values_within(organs[static_cast<std::size_t>(rival)], points);
      for (Eigen::Index i = 0; i < points.cols(); ++i)
        if (other[i] > value[i]) value[i] = other[i], winner[static_cast<std::size_t>(i)] = rival;
    }
    return std::pair(value, winner);
  };
  ScalarField field;
  field.values = [&organ, strongest](const Eigen::Matrix3Xd& points) -> Eigen::VectorXd {
    return organ.own.field.values(points) - strongest(points).first;
  };
  field.gradients = [&organs, &organ, strongest](const Eigen::Matrix3Xd& points) {
    Eigen::Matrix3Xd gradients = organ.own.field.gradients(points);
    const std::vector<int> winner = strongest(points).second;
    for (const int rival : organ.rivals) {
      std::vector<Eigen::Index> lost;
      for (Eigen::Index i = 0; i < points.cols(); ++i)
        if (winner[static_cast<std::size_t>(i)] == rival) lost.push_back(i);
      if (lost.empty()) continue;
      const Eigen::Matrix3Xd other =
          organs[static_cast<std::size_t>(rival)].own.field.gradients(points(Eigen::all, lost));
      for (std::size_t k = 0; k < lost.size(); ++k) gradients.col(lost[k]) -= other.col(static_cast<Eigen::Index>(k));
    }
    return gradients;
  };
  return field;
}

/// Whether vertices of the mesh lie inside the organ.
bool reaches_into(const TriangleMesh& mesh, const Organ& organ) {
  const Eigen::Map<const Eigen::Matrix3Xd> vertices(mesh.vertices_mm.front().data(), 3,
                                                    static_cast<Eigen::Index>(mesh.vertices_mm.size()));
  return (values_within(organ, vertices).array() > 0).any();
}

/// Whether contours of one organ lie inside the other on a plane both were drawn on, as a tumour lies in an organ:
/// then the surfaces may overlap as well.
bool overlap_as_given(const ContourStack& a, const ContourStack& b) {
  constexpr double touching_pixels = 1;
  const auto lies_within = [](const ContourSlice& inner, const ContourSlice& outer) {
    const double touching_mm = touching_pixels * outer.pose.spacing_mm.minCoeff();
    for (const Contour& contour : inner.contours)
      for (const Eigen::Vector2d& p : contour.points_mm) {
        const Eigen::Vector2d in_outer = outer.pose.world_to_slice(inner.pose.slice_to_world(p));
        if (signed_distance_mm(outer.contours, in_outer) > touching_mm) return true;
      }
    return false;
  };
  for (const ContourSlice& of_a : a.slices)
    for (const ContourSlice& of_b : b.slices)
      if (!of_a.contours.empty() && !of_b.contours.empty() &&
          in_one_plane(of_a.pose, of_b.pose, 0.1 * of_a.pose.spacing_mm.minCoeff()) &&
          (lies_within(of_a, of_b) || lies_within(of_b, of_a)))
        return true;
  return false;
}

void find_rivals(const std::vector<ContourStack>& stacks, const std::vector<Reconstruction>& results,
                 std::vector<Organ>& organs) {
  for (std::size_t i = 0; i < organs.size(); ++i)
    for (std::size_t j = i + 1; j < organs.size(); ++j) {
      if (!organs[i].box.intersects(organs[j].box)) continue;
      if (!reaches_into(results[i].surface, organs[j]) && !reaches_into(results[j].surface, organs[i])) continue;
      if (overlap_as_given(stacks[i], stacks[j])) continue;
      organs[i].rivals.push_back(static_cast<int>(j));
      organs[j].rivals.push_back(static_cast<int>(i));
    }
}

}  // namespace

std::vector<Reconstruction> reconstruct_all(const std::vector<ContourStack>& stacks, const ReconstructOptions& options,
                                            const Progress& progress) {
  std::vector<Reconstruction> results;
  if (stacks.size() < 2 || options.allow_overlap) {
    for (const ContourStack& stack : stacks) results.push_back(reconstruct(stack, options, progress));
    return results;
  }
  std::vector<Organ> organs;
  for (const ContourStack& stack : stacks) {
    OrganSurface alone = reconstruct_organ(stack, options, progress);
    const Reconstruction& result = results.emplace_back(std::move(alone.result));
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& v : result.surface.vertices_mm) box.extend(v);
    const double margin = 2 * result.report.resolution_mm;
    box = {box.min().array() - margin, box.max().array() + margin};
    organs.push_back({std::move(alone.fitted), std::move(alone.bounded), box, {}});
  }
  find_rivals(stacks, results, organs);
  for (std::size_t i = 0; i < organs.size(); ++i) {
    if (organs[i].rivals.empty()) {
      retriangulate_organ(organs[i].own, options, progress, results[i]);
      continue;
    }
    BoundedField shared{without_rivals(organs, organs[i]), organs[i].own.bounds};
    require_none_lost(extract_organ(organs[i].fitted, shared, options, progress, results[i]), organs[i].fitted,
                      options);
    retriangulate_organ(shared, options, progress, results[i]);
    results[i].surface.name = stacks[i].name;
    results[i].surface.color = stacks[i].color;
    for (const int rival : organs[i].rivals)
      results[i].report.shares_faces_with.push_back(stacks[static_cast<std::size_t>(rival)].name);
  }
  for (std::size_t i = 0; i < results.size(); ++i)
    results[i].report.sections = agreement_at_inputs(results[i].surface, stacks[i]);
  return results;
}

}  // namespace isostack
