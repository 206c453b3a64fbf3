#include "recon/surface/stack_caps.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace isostack {

namespace {

using Planes = std::vector<Eigen::Hyperplane<double, 3>>;

/// Cuts one mesh at one plane.
class Clipper {
 public:
  Clipper(const TriangleMesh& mesh, const Eigen::Hyperplane<double, 3>& plane) : mesh_(mesh) {
    for (const Eigen::Vector3d& p : mesh.vertices_mm) heights_mm_.push_back(plane.signedDistance(p));
    new_index_.assign(mesh.vertices_mm.size(), -1);
    result_.name = mesh.name;
  }

  TriangleMesh run() {
    for (const Eigen::Vector3i& triangle : mesh_.triangles) add(triangle);
    return std::move(result_);
  }

 private:
  double height(int v) const { return heights_mm_[static_cast<std::size_t>(v)]; }
  bool is_kept(int v) const { return height(v) >= 0; }

  /// The kept part of a triangle is a polygon of up to four corners.
  void add(const Eigen::Vector3i& triangle) {
    std::vector<int> polygon;
    for (int i = 0; i < 3; ++i) {
      const int from = triangle[i], to = triangle[(i + 1) % 3];
      if (is_kept(from)) append(kept_vertex(from), polygon);
      if (is_kept(from) != is_kept(to)) append(cut_vertex(from, to), polygon);
    }
    while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
    for (std::size_t i = 2; i < polygon.size(); ++i)
      result_.triangles.emplace_back(polygon[0], polygon[i - 1], polygon[i]);
  }

  static void append(int vertex, std::vector<int>& polygon) {
    if (polygon.empty() || polygon.back() != vertex) polygon.push_back(vertex);
  }

  int add_vertex(const Eigen::Vector3d& position_mm, const Eigen::Vector3d& normal) {
    result_.vertices_mm.push_back(position_mm);
    if (!mesh_.normals.empty()) result_.normals.push_back(normal.stableNormalized());
    return static_cast<int>(result_.vertices_mm.size()) - 1;
  }

  Eigen::Vector3d normal(int v) const {
    return mesh_.normals.empty() ? Eigen::Vector3d::Zero() : mesh_.normals[static_cast<std::size_t>(v)];
  }

  int kept_vertex(int v) {
    int& index = new_index_[static_cast<std::size_t>(v)];
    if (index < 0) index = add_vertex(mesh_.vertices_mm[static_cast<std::size_t>(v)], normal(v));
    return index;
  }

  int cut_vertex(int a, int b) {
    if (!is_kept(a)) std::swap(a, b);
    if (height(a) == 0) return kept_vertex(a);
    const auto [entry, is_new] = cuts_.emplace(std::pair(a, b), 0);
    if (is_new) {
      const double t = height(a) / (height(a) - height(b));
      const Eigen::Vector3d &from = mesh_.vertices_mm[static_cast<std::size_t>(a)],
                            &to = mesh_.vertices_mm[static_cast<std::size_t>(b)];
      entry->second = add_vertex(from + t * (to - from), normal(a) + t * (normal(b) - normal(a)));
    }
    return entry->second;
  }

  const TriangleMesh& mesh_;
  std::vector<double> heights_mm_;
  std::vector<int> new_index_;
  std::map<std::pair<int, int>, int> cuts_;
  TriangleMesh result_;
};

Eigen::Matrix3Xd projected(Eigen::Matrix3Xd points, const Planes& planes) {
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    for (const auto& plane : planes)
      if (plane.signedDistance(points.col(i)) < 0) points.col(i) = plane.projection(points.col(i));
  return points;
}

}  // namespace

ScalarField extruded_beyond(const ScalarField& field, const Planes& planes) {
  ScalarField extruded;
  extruded.values = [field, planes](const Eigen::Matrix3Xd& points) { return field.values(projected(points, planes)); };
  extruded.gradients = [field, planes](const Eigen::Matrix3Xd& points) {
    Eigen::Matrix3Xd gradients = field.gradients(projected(points, planes));
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      for (const auto& plane : planes)
        if (plane.signedDistance(points.col(i)) < 0)
          gradients.col(i) -= plane.normal().dot(gradients.col(i)) * plane.normal();
    return gradients;
  };
  return extruded;
}

TriangleMesh clipped(TriangleMesh mesh, const Planes& planes) {
  for (const auto& plane : planes) mesh = Clipper(mesh, plane).run();
  return mesh;
}

}  // namespace isostack
