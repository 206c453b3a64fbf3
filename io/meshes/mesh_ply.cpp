#include "io/meshes/mesh_ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "io/atomic_file.h"
#include "io/meshes/mesh_building.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

enum class Encoding { kText, kLittleEndian, kBigEndian };

struct Property {
  std::string name, type, count_type;  ///< count_type is empty unless the property is a list
};
struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};
const std::string name_remark = "comment name: ";

struct Header {
  Encoding encoding = Encoding::kText;
  std::string mesh_name;
  std::vector<Element> elements;
};

/// Takes numbers off a file's bytes in order.
class Cursor {
 public:
  Cursor(std::string bytes, std::string where) : bytes_(std::move(bytes)), where_(std::move(where)) {}

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(where_, problem, "it is truncated or damaged; write it again");
  }
  std::string line() {
    const auto end = bytes_.find('\n', at_);
    if (end == std::string::npos) fail("it is not a whole PLY file");
    std::string result = bytes_.substr(at_, end - at_);
    if (result.ends_with('\r')) result.pop_back();
    at_ = end + 1;
    return result;
  }
  double number(const std::string& type, Encoding encoding) {
    if (encoding == Encoding::kText) return text_number();
    if (type == "char" || type == "int8") return binary<std::int8_t>(encoding);
    if (type == "uchar" || type == "uint8") return binary<std::uint8_t>(encoding);
    if (type == "short" || type == "int16") return binary<std::int16_t>(encoding);
    if (type == "ushort" || type == "uint16") return binary<std::uint16_t>(encoding);
    if (type == "int" || type == "int32") return binary<std::int32_t>(encoding);
    if (type == "uint" || type == "uint32") return binary<std::uint32_t>(encoding);
    if (type == "float" || type == "float32") return binary<float>(encoding);
    if (type == "double" || type == "float64") return binary<double>(encoding);
    fail("it has a property of unknown type '" + type + "'");
  }

 private:
  double text_number() {
    at_ = std::min(bytes_.find_first_not_of(" \t\r\n", at_), bytes_.size());
    double value = 0;
    const char* const end = bytes_.data() + bytes_.size();
    const auto [rest, error] = std::from_chars(bytes_.data() + at_, end, value);
    if (error != std::errc()) fail("a number is missing");
    at_ = static_cast<std::size_t>(rest - bytes_.data());
    return value;
  }
  template <class T>
  double binary(Encoding encoding) {
    std::array<char, sizeof(T)> raw;
    if (raw.size() > bytes_.size() - at_) fail("it ends before its last vertex or face");
    std::memcpy(raw.data(), bytes_.data() + at_, raw.size());
    at_ += raw.size();
    const bool is_big = encoding == Encoding::kBigEndian;
    if (is_big != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
    return static_cast<double>(std::bit_cast<T>(raw));
  }

  std::string bytes_, where_;
  std::size_t at_ = 0;
};

Encoding encoding_from(const std::string& name, const Cursor& cursor) {
  if (name == "ascii") return Encoding::kText;
  if (name == "binary_little_endian") return Encoding::kLittleEndian;
  if (name == "binary_big_endian") return Encoding::kBigEndian;
  cursor.fail("its format '" + name + "' is unknown");
}

Header read_header(Cursor& cursor) {
  Header header;
  if (cursor.line() != "ply") cursor.fail("it does not start as a PLY file");
  for (std::string line = cursor.line(); line != "end_header"; line = cursor.line()) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (line.starts_with(name_remark)) header.mesh_name = line.substr(name_remark.size());
    if (word == "format") {
      words >> word;
      header.encoding = encoding_from(word, cursor);
    } else if (word == "element") {
      Element& element = header.elements.emplace_back();
      words >> element.name >> element.count;
    } else if (word == "property" && !header.elements.empty()) {
      Property& property = header.elements.back().properties.emplace_back();
      words >> property.type;
      if (property.type == "list") words >> property.count_type >> property.type;
      words >> property.name;
    }
  }
  return header;
}

std::vector<long long> read_list(const Property& property, Encoding encoding, Cursor& cursor) {
  const double count = cursor.number(property.count_type, encoding);
  std::vector<long long> values;
  for (double i = 0; i < count; ++i) {
    const double value = cursor.number(property.type, encoding);
    values.push_back(std::abs(value) < 1e15 ? static_cast<long long>(value) : -1);
  }
  return values;
}

void read_vertex(const Element& element, Encoding encoding, Cursor& cursor, TriangleMesh& mesh, CommonColor& color) {
  constexpr std::array<std::string_view, 9> names = {"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue"};
  Eigen::Matrix<double, 9, 1> values;
  values.setConstant(std::numeric_limits<double>::quiet_NaN());
  for (const Property& property : element.properties) {
    if (!property.count_type.empty()) {
      read_list(property, encoding, cursor);
      continue;
    }
    const double value = cursor.number(property.type, encoding);
    const auto* name = std::find(names.begin(), names.end(), property.name);
    if (name != names.end()) values[name - names.begin()] = value;
  }
  mesh.vertices_mm.push_back(values.head<3>());
  if (values.segment<3>(3).allFinite()) mesh.normals.push_back(values.segment<3>(3));
  color.add(values.tail<3>());
}

void read_face(const Element& element, Encoding encoding, Cursor& cursor, TriangleMesh& mesh,
               const std::string& where) {
  for (const Property& property : element.properties) {
    if (property.count_type.empty()) {
      cursor.number(property.type, encoding);
      continue;
    }
    const std::vector<long long> list = read_list(property, encoding, cursor);
    if (property.name == "vertex_indices" || property.name == "vertex_index") add_polygon(list, mesh, where);
  }
}

std::string header_of(const TriangleMesh& mesh) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment LPS mm\n{}element vertex {}\nproperty float x\nproperty float "
      "y\nproperty float z\n{}{}element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.name.empty() ? "" : name_remark + one_line(mesh.name) + "\n", mesh.vertices_mm.size(),
      mesh.normals.empty() ? "" : "property float nx\nproperty float ny\nproperty float nz\n",
      mesh.color ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "", mesh.triangles.size());
}

}  // namespace

TriangleMesh read_ply(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  Cursor cursor(std::string(std::istreambuf_iterator<char>(stream), {}), path.string());
  const Header header = read_header(cursor);
  TriangleMesh mesh;
  mesh.name = header.mesh_name;
  CommonColor color;
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;  // takes no bytes, whatever its count says
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (element.name == "vertex")
        read_vertex(element, header.encoding, cursor, mesh, color);
      else
        read_face(element, header.encoding, cursor, mesh, path.string());
    }
  }
  mesh.color = color.color();
  complete_mesh(mesh, path.string());
  return mesh;
}

void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path) {
  static_assert(std::endian::native == std::endian::little, "values are written as they are in memory");
  const bool has_normals = !mesh.normals.empty();
  std::string bytes = header_of(mesh);
  const auto append = [&](const auto& vector) {
    bytes.append(reinterpret_cast<const char*>(vector.data()), sizeof(vector[0]) * 3);
  };
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i) {
    append(Eigen::Vector3f(mesh.vertices_mm[i].cast<float>()));
    if (has_normals) append(Eigen::Vector3f(mesh.normals[i].cast<float>()));
    if (mesh.color)
      for (const std::uint8_t channel : {mesh.color->red, mesh.color->green, mesh.color->blue})
        bytes += static_cast<char>(channel);
  }
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    bytes += '\3';
    append(triangle);
  }
  write_whole_file(path, bytes);
}

}  // namespace isostack
