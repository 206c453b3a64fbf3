#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/volumes/stored_volume.h"
#include "recon/geometry/contour.h"
#include "recon/geometry/label_map.h"
#include "recon/geometry/triangle_mesh.h"

namespace isostack::testing_support {

// One of each kind, with everything that a format may hold.

inline TriangleMesh octahedron() {
  TriangleMesh mesh{.name = "liver", .vertices_mm = {}, .triangles = {}, .normals = {}, .color = Color{10, 200, 30}};
  for (int axis = 0; axis < 3; ++axis)
    for (const int sign : {1, -1}) {
      mesh.normals.push_back(sign * Eigen::Vector3d::Unit(axis));
      mesh.vertices_mm.push_back(25.0 * mesh.normals.back() + Eigen::Vector3d(1, -2, 300));
    }
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

inline std::vector<ContourStack> two_organs() {
  std::vector<ContourStack> organs;
  for (const double size_mm : {20.0, 6.0}) {
    ContourStack& organ = organs.emplace_back();
    organ.name = size_mm > 10 ? "body" : "tumour";
    organ.color = Color{1, 2, static_cast<std::uint8_t>(size_mm)};
    organ.roi_type = size_mm > 10 ? "EXTERNAL" : "GTV";
    for (int k = 0; k < 3; ++k) {
      ContourSlice& slice = organ.slices.emplace_back();
      slice.name = "slice " + std::to_string(k);
      slice.pose.origin_mm = {-30, 4, 5.0 * k};
      slice.contours = {{.points_mm = {{0, 0}, {size_mm, 0}, {size_mm, size_mm}, {0, size_mm}}}};
    }
  }
  return organs;
}

inline StoredVolume ramp() {
  StoredVolume volume;
  volume.header.value_type = "int16";
  volume.header.grid.size = {4, 3, 2};
  volume.header.grid.index_to_world.linear() = Eigen::Vector3d(0.5, 2, 3).asDiagonal();
  volume.header.grid.index_to_world.translation() = Eigen::Vector3d(-7, 8, 9);
  for (int i = 0; i < 24; ++i) {
    const auto value = static_cast<std::int16_t>(i * 100 - 1000);
    const char* const raw = reinterpret_cast<const char*>(&value);
    volume.bytes.insert(volume.bytes.end(), raw, raw + 2);
  }
  return volume;
}

inline LabelMap two_labels() {
  LabelMap map{.layers = {LabelVolume(ramp().header.grid)}, .segments = {}};
  map.layers[0].voxels[5] = 1;
  map.layers[0].voxels[6] = 2;
  map.segments = {{.name = "liver", .value = 1, .color = Color{9, 8, 7}}, {.name = "spleen", .value = 2}};
  return map;
}

}  // namespace isostack::testing_support
