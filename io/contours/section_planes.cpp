#include "io/contours/section_planes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "io/contours/contour_checks.h"
#include "io/contours/plane_pose.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// Files are written with six digits or so, of planes and vertices both.
constexpr double relative_flatness = 1e-3;

double extent(const std::vector<SectionPlane>& planes) {
  Eigen::AlignedBox3d box;
  for (const SectionPlane& plane : planes)
    for (const Eigen::Vector3d& vertex : plane.vertices_mm) box.extend(vertex);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

/// The largest distance of a vertex from its plane when D is counted with this sign.
double farthest(const SectionPlane& plane, double sign) {
  double result = 0;
  for (const Eigen::Vector3d& vertex : plane.vertices_mm)
    result = std::max(result, std::abs(plane.equation.head<3>().dot(vertex) + sign * plane.equation[3]));
  return result / plane.equation.head<3>().norm();
}

double sign_of_d(const std::vector<SectionPlane>& planes) {
  double added = 0, subtracted = 0;
  for (const SectionPlane& plane : planes) {
    added = std::max(added, farthest(plane, 1));
    subtracted = std::max(subtracted, farthest(plane, -1));
  }
  return subtracted < added ? -1 : 1;
}

double median_edge(const std::vector<SectionPlane>& planes, const std::vector<std::vector<SectionLoop>>& loops) {
  std::vector<double> lengths;
  for (std::size_t p = 0; p < planes.size(); ++p)
    for (const SectionLoop& loop : loops[p])
      for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
        const auto& vertices = planes[p].vertices_mm;
        const auto from = static_cast<std::size_t>(loop.vertices[i]);
        const auto to = static_cast<std::size_t>(loop.vertices[(i + 1) % loop.vertices.size()]);
        const double length = (vertices[from] - vertices[to]).norm();
        if (length > 0) lengths.push_back(length);
      }
  if (lengths.empty()) return 1;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

SlicePose pose_of(const Eigen::Vector4d& equation, double sign) {
  const double length = equation.head<3>().norm();
  return pose_of_plane(equation.head<3>() / length, -sign * equation[3] / length);
}

Contour contour_of(const SectionLoop& loop, const SectionPlane& plane, const SlicePose& pose) {
  Contour contour;
  for (const int vertex : loop.vertices)
    contour.points_mm.push_back(pose.world_to_slice(plane.vertices_mm[static_cast<std::size_t>(vertex)]));
  return contour;
}

/// The curves of a plane, one per loop.
std::vector<Contour> contours_of(const std::vector<SectionLoop>& loops, const SectionPlane& plane,
                                 const SlicePose& pose) {
  std::vector<Contour> contours;
  for (const SectionLoop& loop : loops) contours.push_back(contour_of(loop, plane, pose));
  return contours;
}

/// The label that a loop bounds.
int label_of(const SectionLoop& loop, const Contour& contour, const std::vector<SectionLoop>& loops,
             const std::vector<Contour>& contours) {
  for (const int outer : {loop.hole_of, loop.hole_of - 1}) {
    if (outer < 0 || static_cast<std::size_t>(outer) >= loops.size() || contour.points_mm.empty()) continue;
    const auto index = static_cast<std::size_t>(outer);
    if (&loops[index] != &loop && encloses(contours[index], contour)) return loops[index].label;
  }
  return loop.label;
}

/// Organs whose slices lie this near to one another share a plane of the file.
constexpr double same_plane_mm = 1e-3;

bool is_same_plane(const SlicePose& a, const SlicePose& b) {
  return are_parallel(a, b, 1e-6) && std::abs(a.signed_distance_mm(b.origin_mm)) < same_plane_mm;
}

}  // namespace

std::vector<SlicePose> section_poses(const std::vector<SectionPlane>& planes,
                                     const std::vector<std::vector<SectionLoop>>& loops) {
  for (const SectionPlane& plane : planes)
    if (!(plane.equation.head<3>().norm() > 1e-12))
      throw InputError(plane.where, "the plane has no normal: A, B and C are zero", "repair the file");
  const double sign = sign_of_d(planes), allowed = relative_flatness * extent(planes) + 1e-9;
  const double spacing_mm = median_edge(planes, loops);
  std::vector<SlicePose> poses;
  for (const SectionPlane& plane : planes) {
    if (const double off = farthest(plane, sign); !(off <= allowed))
      throw InputError(plane.where, fmt::format("a vertex lies {:.3g} mm off its plane", off),
                       "repair A, B, C, D or the vertices");
    poses.push_back(pose_of(plane.equation, sign));
    poses.back().spacing_mm.setConstant(spacing_mm);
  }
  return poses;
}

std::vector<ContourStack> section_organs(const std::vector<SectionPlane>& planes,
                                         const std::vector<std::vector<SectionLoop>>& loops, const std::string& file,
                                         long long label_count) {
  const std::vector<SlicePose> poses = section_poses(planes, loops);
  std::vector<std::vector<Contour>> contours;
  std::vector<std::vector<int>> label_of_loop;
  std::set<int> labels;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    contours.push_back(contours_of(loops[p], planes[p], poses[p]));
    std::vector<int>& of_plane = label_of_loop.emplace_back();
    for (std::size_t i = 0; i < loops[p].size(); ++i)
      of_plane.push_back(label_of(loops[p][i], contours[p][i], loops[p], contours[p]));
    labels.insert(of_plane.begin(), of_plane.end());
  }
  labels.insert(0);
  constexpr long long most_unseen = 256;  // a larger count is no list of organs
  if (*labels.rbegin() < label_count && label_count <= most_unseen)
    for (int label = 1; label < label_count; ++label) labels.insert(label);
  labels.erase(0);
  std::vector<ContourStack> organs;
  for (const int label : labels) {
    ContourStack& organ = organs.emplace_back(ContourStack{.name = std::to_string(label), .slices = {}});
    for (std::size_t p = 0; p < planes.size(); ++p) {
      ContourSlice& slice = organ.slices.emplace_back(
          ContourSlice{.name = fmt::format("plane {}", p + 1), .pose = poses[p], .contours = {}});
      for (std::size_t i = 0; i < contours[p].size(); ++i)
        if (label_of_loop[p][i] == label) slice.contours.push_back(contours[p][i]);
      complete_slice(slice, file);
    }
  }
  return organs;
}

std::vector<WrittenPlane> planes_of(const std::vector<ContourStack>& organs) {
  std::vector<WrittenPlane> planes;
  for (std::size_t o = 0; o < organs.size(); ++o)
    for (const ContourSlice& slice : organs[o].slices) {
      auto plane = std::find_if(planes.begin(), planes.end(), [&](const WrittenPlane& p) {
        return p.contours[o].empty() && is_same_plane(p.pose, slice.pose);
      });
      if (plane == planes.end())
        plane = planes.insert(planes.end(), {.pose = slice.pose,
                                             .contours = std::vector<std::vector<Contour>>(organs.size()),
                                             .normal = slice.pose.normal()});
      for (const Contour& contour : slice.contours) {
        Contour& moved = plane->contours[o].emplace_back();
        for (const Eigen::Vector2d& point : contour.points_mm)
          moved.points_mm.push_back(plane->pose.world_to_slice(slice.pose.slice_to_world(point)));
      }
    }
  for (WrittenPlane& plane : planes)
    for (std::vector<Contour>& contours : plane.contours) orient_by_nesting(contours);
  return planes;
}

}  // namespace isostack
