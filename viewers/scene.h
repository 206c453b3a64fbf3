#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/slice.h"
#include "recon/geometry/triangle_mesh.h"
#include "viewers/colour_map.h"

namespace isostack {

/// A number for every vertex of a surface, shown as its colour and on a colour bar.
struct VertexValues {
  std::string label = {};           ///< on the bar, with the unit: "distance, mm"
  std::vector<double> values = {};  ///< one per vertex; what is not finite is drawn grey
  ColourRange range = {};
};

enum class SurfaceStyle { shaded, wire };

struct SceneSurface {
  TriangleMesh mesh;
  SurfaceStyle style = SurfaceStyle::shaded;
  double opacity = 1;                       ///< 0 to 1; below 1 what is behind shows through
  std::optional<VertexValues> values = {};  ///< none: the mesh's colour, or that of its place in the scene
  bool visible = true;
};

struct SceneContours {
  ContourStack stack;
  double opacity = 1;
  bool visible = true;
};

/// An image in its plane.
struct SceneSlice {
  Slice image;
  double opacity = 1;
  bool visible = true;
};

/// A straight stretch that is pointed out: a measured distance, a contradiction between slices.
struct SceneMark {
  Eigen::Vector3d from_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d to_mm = Eigen::Vector3d::Zero();
  std::string text = {};  ///< beside its middle
  bool visible = true;
};

/// What there is to look at, all in world LPS mm. Windows, pictures and pages all show this.
struct Scene {
  std::string title = {};  ///< names of files and key numbers; nothing of the patient
  std::vector<SceneSurface> surfaces = {};
  std::vector<SceneContours> contours = {};
  std::vector<SceneSlice> slices = {};
  std::vector<SceneMark> marks = {};
};

/// Each organ's contours and surface as items of a scene, in their order.
std::vector<SceneSurface> scene_surfaces(std::vector<TriangleMesh> meshes);
std::vector<SceneContours> scene_contours(std::vector<ContourStack> organs);
std::vector<SceneSlice> scene_slices(std::vector<Slice> slices);

}  // namespace isostack
