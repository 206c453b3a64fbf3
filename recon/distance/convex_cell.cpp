#include "recon/distance/convex_cell.h"

namespace isostack {

using Eigen::Vector3d;

void ConvexCell::clear() {
  corners_.clear();
  ends_.clear();
}

void ConvexCell::add_face(std::initializer_list<Vector3d> corners) {
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  end_face();
}

Eigen::AlignedBox3d ConvexCell::box() const {
  Eigen::AlignedBox3d box;
  for (const Vector3d& corner : corners_) box.extend(corner);
  return box;
}

void ConvexCell::slice(double z) {
  segments_.clear();
  std::size_t first = 0;
  for (const std::size_t end : ends_) {
    Segment segment{};
    int found = 0;
    const auto add = [&](double x, double y) {
      if (found == 0) {
        segment = {x, y, x, y};
      } else if (found == 1) {
        segment.x1 = x, segment.y1 = y;
      } else {
        segments_.push_back({segment.x1, segment.y1, x, y});  // a face in the plane, or a corner met twice
        segment.x1 = x, segment.y1 = y;
      }
      ++found;
    };
    for (std::size_t i = first; i < end; ++i) {
      const Vector3d& a = corners_[i];
      const Vector3d& b = corners_[i + 1 < end ? i + 1 : first];
      if (a.z() == z) {
        add(a.x(), a.y());
      } else if ((a.z() < z && b.z() > z) || (a.z() > z && b.z() < z)) {
        const double t = (z - a.z()) / (b.z() - a.z());
        add(a.x() + t * (b.x() - a.x()), a.y() + t * (b.y() - a.y()));
      }
    }
    if (found > 0) segments_.push_back(segment);
    first = end;
  }
}

}  // namespace isostack
