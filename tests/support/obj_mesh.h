#pragma once

#include <fstream>
#include <sstream>
#include <string>

#include "recon/geometry/triangle_mesh.h"

namespace isostack::testing_support {

/// Vertices and triangles of an OBJ file, for tests that link no reader.
inline TriangleMesh obj_mesh(const std::string& path) {
  TriangleMesh mesh;
  mesh.name = path;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word, corners[3];
    words >> word;
    if (word == "v") {
      Eigen::Vector3d& v = mesh.vertices_mm.emplace_back();
      words >> v.x() >> v.y() >> v.z();
    } else if (word == "f" && words >> corners[0] >> corners[1] >> corners[2]) {
      mesh.triangles.emplace_back(std::stoi(corners[0]) - 1, std::stoi(corners[1]) - 1, std::stoi(corners[2]) - 1);
    }
  }
  return mesh;
}

}  // namespace isostack::testing_support
