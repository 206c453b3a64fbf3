#include "io/mesh_gltf.h"

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
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
    document["buffers"] = {
        {{"byteLength", bytes_.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}};
  }

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

}  // namespace

void write_gltf(const TriangleMesh& mesh, const std::filesystem::path& path) {
  Json document = {{"asset", {{"version", "2.0"}, {"generator", "isostack"}}}, {"scene", 0}};
  if (!mesh.triangles.empty()) {  // glTF forbids empty arrays
    Buffer buffer;
    Json attributes = {{"POSITION", add_positions(mesh, buffer)}};
    if (!mesh.normals.empty()) attributes["NORMAL"] = add_normals(mesh, buffer);
    const std::size_t indices = add_indices(mesh, buffer);
    document["meshes"] = Json::array(
        {{{"name", mesh.name}, {"primitives", Json::array({{{"attributes", attributes}, {"indices", indices}}})}}});
    document["nodes"] = Json::array({{{"mesh", 0}}});
    document["scenes"] = Json::array({{{"nodes", {0}}}});
    buffer.describe(document);
  } else {
    document["scenes"] = Json::array({Json::object()});
  }
  write_whole_file(path, document.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace isostack
