#include "recon/distance/winding_number.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace isostack {

using Eigen::Vector3d;

namespace {

/// Signed solid angle of a triangle seen from the origin (Van Oosterom and Strackee 1983).
double solid_angle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

}  // namespace

struct WindingNumber::Tree {
  struct Node {
    Vector3d centre = Vector3d::Zero();  ///< of area
    Vector3d dipole = Vector3d::Zero();  ///< sum of area × outward normal
    double radius = 0;                   ///< round the centre
    int first = 0, last = 0;             ///< in `order`
    int children = -1;                   ///< the first of two; -1: a leaf
  };

  const TriangleMesh mesh;
  std::vector<int> order;
  std::vector<Node> nodes;

  explicit Tree(const TriangleMesh& of) : mesh(of), order(of.triangles.size()) {
    std::iota(order.begin(), order.end(), 0);
    nodes.emplace_back();
    build(0, 0, static_cast<int>(order.size()));
  }

  const Vector3d& corner(int triangle, int i) const {
    return mesh.vertices_mm[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(triangle)][i])];
  }
  Vector3d middle(int t) const { return (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3; }

  void build(int number, int first, int last) {
    constexpr int triangles_of_leaf = 8;
    Node node;
    node.first = first, node.last = last;
    double area = 0;
    Eigen::AlignedBox3d box;
    for (int n = first; n < last; ++n) {
      const int t = order[static_cast<std::size_t>(n)];
      const Vector3d normal = 0.5 * (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
      node.dipole += normal;
      node.centre += normal.norm() * middle(t);
      area += normal.norm();
      box.extend(middle(t));
    }
    node.centre = area > 0 ? Vector3d(node.centre / area) : box.center();
    for (int n = first; n < last; ++n)
      for (int i = 0; i < 3; ++i)
        node.radius = std::max(node.radius, (corner(order[static_cast<std::size_t>(n)], i) - node.centre).norm());
    if (last - first > triangles_of_leaf) {
      int axis = 0;
      box.sizes().maxCoeff(&axis);
      const int half = (first + last) / 2;
      std::nth_element(order.begin() + first, order.begin() + half, order.begin() + last,
                       [&](int a, int b) { return middle(a)[axis] < middle(b)[axis]; });
      node.children = static_cast<int>(nodes.size());
      nodes.resize(nodes.size() + 2);
      build(node.children, first, half);
      build(node.children + 1, half, last);
    }
    nodes[static_cast<std::size_t>(number)] = node;
  }

  double solid_angle_at(const Vector3d& point, int number) const {
    constexpr double far = 2.5;  // in radii
    const Node& node = nodes[static_cast<std::size_t>(number)];
    const Vector3d to = node.centre - point;
    const double distance = to.norm();
    if (distance > far * node.radius) return node.dipole.dot(to) / (distance * distance * distance);
    if (node.children >= 0) return solid_angle_at(point, node.children) + solid_angle_at(point, node.children + 1);
    double sum = 0;
    for (int n = node.first; n < node.last; ++n) {
      const int t = order[static_cast<std::size_t>(n)];
      sum += solid_angle(corner(t, 0) - point, corner(t, 1) - point, corner(t, 2) - point);
    }
    return sum;
  }
};

WindingNumber::WindingNumber(const TriangleMesh& mesh) : tree_(std::make_shared<const Tree>(mesh)) {}

double WindingNumber::at(const Vector3d& point_mm) const {
  return tree_->solid_angle_at(point_mm, 0) / (4 * std::numbers::pi);
}

}  // namespace isostack
