#include "io/meshes/mesh_gltf.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/atomic_file.h"

namespace isostack {

namespace {

using Json = nlohmann::json;

// Names from the glTF 2.0 specification, section 3.6 and 3.7.
constexpr int component_float = 5126, component_uint32 = 5125;
constexpr int target_array = 34962, target_elements = 34963;

std::string base64(const std::string& bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) group = group << 8 | (j < count ? static_cast<std::uint8_t>(bytes[i + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j) text += j <= count ? digits[group >> (18 - 6 * j) & 63] : '=';
  }
  return text;
}

/// (left, posterior, superior) to (left, superior, anterior), a rotation.
Eigen::Vector3f y_up(const Eigen::Vector3d& lps) { return Eigen::Vector3d(lps.x(), lps.z(), -lps.y()).cast<float>(); }

/// Collects the arrays of one buffer with their views and accessors.
class Buffer {
 public:
  /// Returns the accessor's index.
  template <class T>
  std::size_t add(const std::vector<T>& values, int component, const char* type, int target) {
    const std::size_t bytes = values.size() * sizeof(T);
    views_.push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes}, {"target", target}});
    accessors_.push_back(
        {{"bufferView", views_.size() - 1}, {"componentType", component}, {"count", values.size()}, {"type", type}});
    bytes_.append(reinterpret_cast<const char*>(values.data()), bytes);
    return accessors_.size() - 1;
  }
  Json& accessor(std::size_t index) { return accessors_[index]; }

  void describe(Json& document) const {
    document["accessors"] = accessors_;
    document["bufferViews"] = views_;
    document["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
  }
  const std::string& bytes() const { return bytes_; }

 private:
  Json views_ = Json::array(), accessors_ = Json::array();
  std::string bytes_;
};

std::size_t add_positions(const TriangleMesh& mesh, Buffer& buffer) {
  std::vector<Eigen::Vector3f> positions_m;
  Eigen::Array3f low = Eigen::Array3f::Constant(std::numeric_limits<float>::max()), high = -low;
  for (const Eigen::Vector3d& vertex : mesh.vertices_mm) {
    positions_m.push_back(y_up(vertex / 1000));
    low = low.min(positions_m.back().array());
    high = high.max(positions_m.back().array());
  }
  const std::size_t index = buffer.add(positions_m, component_float, "VEC3", target_array);
  buffer.accessor(index)["min"] = {low.x(), low.y(), low.z()};
  buffer.accessor(index)["max"] = {high.x(), high.y(), high.z()};
  return index;
}

std::size_t add_normals(const TriangleMesh& mesh, Buffer& buffer) {
  std::vector<Eigen::Vector3f> normals;
  for (const Eigen::Vector3d& normal : mesh.normals) normals.push_back(y_up(normal));
  return buffer.add(normals, component_float, "VEC3", target_array);
}

std::size_t add_indices(const TriangleMesh& mesh, Buffer& buffer) {
  std::vector<std::uint32_t> indices;
  for (const Eigen::Vector3i& triangle : mesh.triangles)
    for (const int corner : triangle) indices.push_back(static_cast<std::uint32_t>(corner));
  return buffer.add(indices, component_uint32, "SCALAR", target_elements);
}

/// glTF's colours are linear; 8-bit colours are sRGB (IEC 61966-2-1).
double linear(std::uint8_t srgb) {
  const double value = srgb / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

Json material_of(const Color& color, const std::string& name) {
  return {{"name", name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {linear(color.red), linear(color.green), linear(color.blue), 1}},
            {"metallicFactor", 0},
            {"roughnessFactor", 0.6}}}};
}

/// The document without its buffer's bytes, which go into `buffer`.
Json document_of(const TriangleMesh& mesh, Buffer& buffer) {
  Json document = {{"asset", {{"version", "2.0"}, {"generator", "isostack"}}}, {"scene", 0}};
  if (mesh.triangles.empty()) {  // glTF forbids empty arrays
    document["scenes"] = Json::array({Json::object()});
    return document;
  }
  Json primitive = {{"attributes", {{"POSITION", add_positions(mesh, buffer)}}}};
  if (!mesh.normals.empty()) primitive["attributes"]["NORMAL"] = add_normals(mesh, buffer);
  primitive["indices"] = add_indices(mesh, buffer);
  if (mesh.color) {
    document["materials"] = Json::array({material_of(*mesh.color, mesh.name)});
    primitive["material"] = 0;
  }
  document["meshes"] = Json::array({{{"name", mesh.name}, {"primitives", Json::array({primitive})}}});
  document["nodes"] = Json::array({{{"mesh", 0}, {"name", mesh.name}}});
  document["scenes"] = Json::array({{{"nodes", {0}}}});
  buffer.describe(document);
  return document;
}

std::string text_of(const Json& document) { return document.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string little_endian(std::size_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

/// A chunk of GLB (glTF 2.0, section 4.4), padded to four bytes.
std::string chunk(std::string content, char padding, std::string_view type) {
  while (content.size() % 4 != 0) content += padding;
  return little_endian(content.size()) + std::string(type) + content;
}

}  // namespace

void write_gltf(const TriangleMesh& mesh, const std::filesystem::path& path) {
  Buffer buffer;
  Json document = document_of(mesh, buffer);
  if (document.contains("buffers"))
    document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(buffer.bytes());
  write_whole_file(path, text_of(document));
}

void write_glb(const TriangleMesh& mesh, const std::filesystem::path& path) {
  Buffer buffer;
  std::string chunks = chunk(text_of(document_of(mesh, buffer)), ' ', "JSON");
  if (!buffer.bytes().empty()) chunks += chunk(buffer.bytes(), '\0', std::string_view("BIN\0", 4));
  constexpr std::size_t header_bytes = 12, version = 2;
  write_whole_file(path, "glTF" + little_endian(version) + little_endian(header_bytes + chunks.size()) + chunks);
}

}  // namespace isostack
