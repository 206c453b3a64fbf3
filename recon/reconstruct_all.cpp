#include "recon/reconstruct_all.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "recon/geometry/errors.h"
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

void find_rivals(const std::vector<Reconstruction>& results, std::vector<Organ>& organs) {
  for (std::size_t i = 0; i < organs.size(); ++i)
    for (std::size_t j = i + 1; j < organs.size(); ++j) {
      if (!organs[i].box.intersects(organs[j].box)) continue;
      if (!reaches_into(results[i].surface, organs[j]) && !reaches_into(results[j].surface, organs[i])) continue;
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
    require_two_slices(stack);
    Reconstruction& result = results.emplace_back();
    FittedOrgan fitted = fit_organ(stack, options, progress, result.report);
    BoundedField own = bounded_field(fitted, options);
    extract_organ(fitted, own, options, progress, result);
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& v : result.surface.vertices_mm) box.extend(v);
    const double margin = 2 * result.report.resolution_mm;
    box = {box.min().array() - margin, box.max().array() + margin};
    organs.push_back({std::move(fitted), std::move(own), box, {}});
    result.surface.name = stack.name;
  }
  find_rivals(results, organs);
  for (std::size_t i = 0; i < organs.size(); ++i) {
    if (organs[i].rivals.empty()) continue;
    BoundedField shared{without_rivals(organs, organs[i]), organs[i].own.bounds};
    extract_organ(organs[i].fitted, shared, options, progress, results[i]);
    results[i].surface.name = stacks[i].name;
    for (const int rival : organs[i].rivals)
      results[i].report.shares_faces_with.push_back(stacks[static_cast<std::size_t>(rival)].name);
  }
  return results;
}

}  // namespace isostack
