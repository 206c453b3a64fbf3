#include "viewers/page/page_data.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "viewers/mesh_proxy.h"
#include "viewers/page/base64.h"
#include "viewers/page/grey_png.h"
#include "viewers/palette.h"
#include "viewers/scene_points.h"

namespace isostack {

namespace {

static_assert(std::endian::native == std::endian::little, "browsers read arrays in the order they are in memory");

template <class T>
std::string packed(const std::vector<T>& values) {
  return base64(std::as_bytes(std::span(values)));
}

std::string hex(const Color& c) { return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue); }

std::string hex(const Eigen::Vector3d& rgb) {
  const auto channel = [](double share) { return static_cast<std::uint8_t>(std::lround(255 * share)); };
  return hex(Color{channel(rgb.x()), channel(rgb.y()), channel(rgb.z())});
}

nlohmann::json array_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

nlohmann::json vertices_of(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices_mm) box.extend(v);
  const double step_mm = std::max(box.sizes().maxCoeff(), 1e-9) / 65535;
  std::vector<std::uint16_t> places;
  places.reserve(3 * mesh.vertices_mm.size());
  for (const Eigen::Vector3d& v : mesh.vertices_mm)
    for (int axis = 0; axis < 3; ++axis)
      places.push_back(static_cast<std::uint16_t>(std::lround((v[axis] - box.min()[axis]) / step_mm)));
  return {{"from", array_of(box.min())}, {"step", step_mm}, {"places", packed(places)}};
}

std::string normals_of(const TriangleMesh& mesh) {
  std::vector<std::int8_t> components;
  for (const Eigen::Vector3d& normal : mesh.normals)
    for (const double component : normal)
      components.push_back(static_cast<std::int8_t>(std::lround(127 * std::clamp(component, -1.0, 1.0))));
  return packed(components);
}

nlohmann::json bar_of(const VertexValues& values) {
  constexpr int stops = 17;
  nlohmann::json colours = nlohmann::json::array();
  for (int i = 0; i < stops; ++i)
    colours.push_back(
        hex(colour_of(values.range.low + (values.range.high - values.range.low) * i / (stops - 1), values.range)));
  return {{"label", values.label}, {"low", values.range.low}, {"high", values.range.high}, {"colours", colours}};
}

nlohmann::json surface_data(const SceneSurface& item, std::size_t index, std::size_t most_triangles) {
  MeshProxy proxy;
  const bool is_large = item.mesh.triangles.size() > most_triangles;
  if (is_large) proxy = mesh_proxy(item.mesh, most_triangles);
  const TriangleMesh& mesh = is_large ? proxy.mesh : item.mesh;
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (const Eigen::Vector3i& triangle : mesh.triangles)
    for (const int corner : triangle) corners.push_back(static_cast<std::uint32_t>(corner));
  nlohmann::json data = {{"name", item.mesh.name.empty() ? fmt::format("surface {}", index + 1) : item.mesh.name},
                         {"colour", item.mesh.color ? hex(*item.mesh.color) : hex(organ_colours(index).surface)},
                         {"opacity", item.opacity},
                         {"wire", item.style == SurfaceStyle::wire},
                         {"visible", item.visible},
                         {"vertices", vertices_of(mesh)},
                         {"triangles", packed(corners)}};
  if (mesh.normals.size() == mesh.vertices_mm.size()) data["normals"] = normals_of(mesh);
  if (!item.values) return data;
  std::vector<std::uint8_t> colours;
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i) {
    const Color c = colour_of(item.values->values[is_large ? proxy.source_vertex[i] : i], item.values->range);
    colours.insert(colours.end(), {c.red, c.green, c.blue});
  }
  data["colours"] = packed(colours);
  data["bar"] = bar_of(*item.values);
  return data;
}

/// Both ends of every edge, single precision.
nlohmann::json contours_data(const SceneContours& item, std::size_t index) {
  std::vector<float> ends;
  for (const ContourSlice& slice : item.stack.slices)
    for (const Contour& contour : slice.contours)
      for (std::size_t i = 0; i < contour.points_mm.size(); ++i)
        for (const std::size_t end : {i, (i + 1) % contour.points_mm.size()}) {
          const Eigen::Vector3d point = slice.pose.slice_to_world(contour.points_mm[end]);
          for (const double coordinate : point) ends.push_back(static_cast<float>(coordinate));
        }
  return {{"name", item.stack.name.empty() ? fmt::format("contours {}", index + 1) : item.stack.name},
          {"colour", item.stack.color ? hex(*item.stack.color) : hex(organ_colours(index).contour)},
          {"visible", item.visible},
          {"ends", packed(ends)}};
}

/// Means over blocks of `factor` × `factor` pixels; what does not fill a block at the right and bottom goes into the
/// last.
Image<float> reduced(const Image<float>& pixels, Eigen::Index factor) {
  const Eigen::Index rows = std::max<Eigen::Index>(1, pixels.rows() / factor);
  const Eigen::Index columns = std::max<Eigen::Index>(1, pixels.cols() / factor);
  Image<float> small(rows, columns);
  for (Eigen::Index row = 0; row < rows; ++row)
    for (Eigen::Index column = 0; column < columns; ++column) {
      const Eigen::Index height = row + 1 == rows ? pixels.rows() - row * factor : factor;
      const Eigen::Index width = column + 1 == columns ? pixels.cols() - column * factor : factor;
      small(row, column) = pixels.block(row * factor, column * factor, height, width).mean();
    }
  return small;
}

nlohmann::json slices_data(const Scene& scene, const PageOptions& options) {
  double pixels = 0;
  for (const SceneSlice& item : scene.slices) pixels += static_cast<double>(item.image.pixels.size());
  const auto factor = static_cast<Eigen::Index>(
      std::ceil(std::sqrt(pixels / static_cast<double>(std::max<std::size_t>(1, options.most_image_pixels)))));
  const GreyWindow grey = options.grey ? *options.grey : automatic_grey_window(scene);
  nlohmann::json slices = nlohmann::json::array();
  for (const SceneSlice& item : scene.slices) {
    if (item.image.pixels.size() == 0) continue;
    nlohmann::json corners = nlohmann::json::array();
    for (const Eigen::Vector3d& corner : corners_of(item.image)) corners.push_back(array_of(corner));
    const Image<std::uint8_t> shown =
        grey_levels(factor > 1 ? reduced(item.image.pixels, factor) : item.image.pixels, grey);
    slices.push_back({{"corners", corners},
                      {"opacity", item.opacity},
                      {"visible", item.visible},
                      {"png", "data:image/png;base64," + packed(grey_png(shown))}});
  }
  return slices;
}

}  // namespace

nlohmann::json page_data(const Scene& scene, const PageOptions& options) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : visible_points(scene)) box.extend(point);
  nlohmann::json data = {{"title", scene.title},
                         {"dark", options.dark},
                         {"view_from", array_of(options.view_from)},
                         {"box", {array_of(box.min()), array_of(box.max())}},
                         {"surfaces", nlohmann::json::array()},
                         {"contours", nlohmann::json::array()},
                         {"slices", slices_data(scene, options)},
                         {"marks", nlohmann::json::array()}};
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
    data["surfaces"].push_back(surface_data(scene.surfaces[i], i, options.most_triangles));
  for (std::size_t i = 0; i < scene.contours.size(); ++i)
    data["contours"].push_back(contours_data(scene.contours[i], i));
  for (const SceneMark& mark : scene.marks)
    data["marks"].push_back({{"from", array_of(mark.from_mm)},
                             {"to", array_of(mark.to_mm)},
                             {"text", mark.text},
                             {"visible", mark.visible}});
  return data;
}

}  // namespace isostack
