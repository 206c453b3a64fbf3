#include "viewers/cut_lines.h"

#include <iterator>
#include <utility>

#include "recon/surface/plane_section.h"

namespace isostack {

std::vector<Contour> cut_lines(const TriangleMesh& mesh, const SlicePose& pose) {
  SectionLines lines = section_lines(mesh, pose);
  for (std::vector<Eigen::Vector2d>& there : lines.open) {
    const std::vector<Eigen::Vector2d> back(std::next(there.rbegin()), std::prev(there.rend()));
    there.insert(there.end(), back.begin(), back.end());
    lines.closed.push_back({.points_mm = std::move(there)});
  }
  return std::move(lines.closed);
}

}  // namespace isostack
