#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <vector>

namespace isostack {

/// A convex polyhedron as the loops of its faces (and maybe further polygons inside it), made to be filled again and
/// again without new memory.
class ConvexCell {
 public:
  void clear();
  bool empty() const { return ends_.empty(); }
  void add_face(std::initializer_list<Eigen::Vector3d> corners);
  void add_corner(const Eigen::Vector3d& corner) { corners_.push_back(corner); }
  void end_face() { ends_.push_back(corners_.size()); }

  /// visit(j, k, first_i, last_i) for every row of lattice nodes in the cell, first_k <= k <= last_k, nodes within
  /// [0, size). The cell is taken for a little larger (1e-3 along each axis), so that no node between two touching
  /// cells is lost to rounding.
  template <class Visit>
  void for_each_row(const Eigen::Vector3i& size, int first_k, int last_k, Visit visit);

 private:
  struct Segment {
    double x0, y0, x1, y1;
  };
  /// Where the plane z cuts the faces.
  void slice(double z);
  Eigen::AlignedBox3d box() const;

  std::vector<Eigen::Vector3d> corners_;
  std::vector<std::size_t> ends_;
  std::vector<Segment> segments_;
};

template <class Visit>
void ConvexCell::for_each_row(const Eigen::Vector3i& size, int first_k, int last_k, Visit visit) {
  constexpr double slack = 1e-3;
  const Eigen::AlignedBox3d around = box();
  const auto first_node = [](double low) { return static_cast<int>(std::ceil(std::max(low - slack, -1.0))); };
  const auto last_node = [](double high, int last) {
    return static_cast<int>(std::floor(std::min(high + slack, static_cast<double>(last))));
  };
  first_k = std::max(first_k, first_node(around.min().z()));
  last_k = std::min(last_k, last_node(around.max().z(), size.z()));
  for (int k = first_k; k <= last_k; ++k) {
    slice(std::clamp(static_cast<double>(k), around.min().z(), around.max().z()));
    double low_y = std::numeric_limits<double>::infinity(), high_y = -low_y;
    for (const Segment& s : segments_) {
      low_y = std::min({low_y, s.y0, s.y1});
      high_y = std::max({high_y, s.y0, s.y1});
    }
    if (!(low_y <= high_y)) continue;
    const int last_j = std::min(size.y() - 1, last_node(high_y, size.y()));
    for (int j = std::max(0, first_node(low_y)); j <= last_j; ++j) {
      const double y = std::clamp(static_cast<double>(j), low_y, high_y);
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const Segment& s : segments_) {
        if ((y < s.y0 && y < s.y1) || (y > s.y0 && y > s.y1)) continue;
        if (s.y0 == s.y1) {
          low = std::min({low, s.x0, s.x1});
          high = std::max({high, s.x0, s.x1});
        } else {
          const double x = s.x0 + (y - s.y0) / (s.y1 - s.y0) * (s.x1 - s.x0);
          low = std::min(low, x);
          high = std::max(high, x);
        }
      }
      if (!(low <= high)) continue;
      const int first = std::max(0, first_node(low)), last = std::min(size.x() - 1, last_node(high, size.x()));
      if (first <= last) visit(j, k, first, last);
    }
  }
}

}  // namespace isostack
