#include "viewers/scene.h"

#include <utility>

namespace isostack {

std::vector<SceneSurface> scene_surfaces(std::vector<TriangleMesh> meshes) {
  std::vector<SceneSurface> items;
  items.reserve(meshes.size());
  for (TriangleMesh& mesh : meshes) items.push_back({.mesh = std::move(mesh)});
  return items;
}

std::vector<SceneContours> scene_contours(std::vector<ContourStack> organs) {
  std::vector<SceneContours> items;
  items.reserve(organs.size());
  for (ContourStack& organ : organs) items.push_back({.stack = std::move(organ)});
  return items;
}

std::vector<SceneSlice> scene_slices(std::vector<Slice> slices) {
  std::vector<SceneSlice> items;
  items.reserve(slices.size());
  for (Slice& slice : slices) items.push_back({.image = std::move(slice)});
  return items;
}

}  // namespace isostack
