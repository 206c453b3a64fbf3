#pragma once

#include <optional>
#include <span>
#include <string>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Adds a polygon as a fan of triangles. Throws InputError naming `where` when a corner is not a
/// vertex of the mesh.
void add_polygon(std::span<const long long> corners, TriangleMesh& mesh, const std::string& where);

/// What every mesh reader does at the end: normals become unit vectors, or are dropped when there is not one per
/// vertex. Throws InputError naming `where` when there is no triangle or a coordinate is not a number.
void complete_mesh(TriangleMesh& mesh, const std::string& where);

/// The text on one line, for formats of lines.
std::string one_line(std::string text);

/// The colour of a mesh from those of its vertices: none unless all of them have the same.
class CommonColor {
 public:
  /// Red, green, blue from 0 to 255; anything else is no colour.
  void add(const Eigen::Vector3d& channels);
  std::optional<Color> color() const { return differs_ ? std::nullopt : color_; }

 private:
  std::optional<Color> color_;
  bool differs_ = false;
};

/// Makes vertices at exactly one place one vertex and drops triangles that collapse. Formats that
/// repeat a vertex for each face or texture would otherwise fall apart at the seams.
void merge_coinciding(TriangleMesh& mesh);

}  // namespace isostack
