#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

#include "io/meshes/read_mesh.h"
#include "io/meshes/write_mesh.h"
#include "tests/io/io_support.h"

namespace isostack {
namespace {

using testing::bytes_of;
using testing::TemporaryFolder;
using testing::write_bytes;

TriangleMesh tetrahedron() {
  return {.name = "left kidney",
          .vertices_mm = {{0, 0, 0}, {40, 0, 0}, {0, 30, 0}, {0, 0, 20}},
          .triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
          .normals = {},
          .color = Color{200, 60, 5}};
}

class MeshLooks : public ::testing::TestWithParam<const char*> {};

TEST_P(MeshLooks, NameAndColourComeBack) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("a") + GetParam());
  write_mesh(tetrahedron(), path);
  const TriangleMesh read = read_mesh(path);
  EXPECT_EQ(read.name, "left kidney");
  EXPECT_EQ(read.color, tetrahedron().color);
  EXPECT_EQ(read.vertices_mm.size(), 4u);
}

TEST_P(MeshLooks, WithoutColourThereIsNone) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("a") + GetParam());
  TriangleMesh mesh = tetrahedron();
  mesh.color.reset();
  mesh.name.clear();
  write_mesh(mesh, path);
  EXPECT_FALSE(read_mesh(path).color);
  EXPECT_EQ(read_mesh(path).name, "a");  // the file's
}

TEST_P(MeshLooks, RasFilesAreTurnedBothWays) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("a") + GetParam());
  write_mesh(tetrahedron(), path, {.axes = MeshAxes::ras});
  EXPECT_EQ(read_mesh(path).vertices_mm[1], Eigen::Vector3d(-40, 0, 0));
  EXPECT_EQ(read_mesh(path, MeshAxes::ras).vertices_mm[2], Eigen::Vector3d(0, 30, 0));
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshLooks, ::testing::Values(".ply", ".obj", ".vtp"),
                         [](const auto& format) { return std::string(format.param).substr(1); });

TEST(MeshLooksMixed, VerticesOfSeveralColoursHaveNoCommonOne) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.obj", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 0 1 0\nf 1 2 3\n");
  EXPECT_FALSE(read_mesh(folder / "a.obj").color);
}

TEST(MeshLooksGltf, BinaryFileHoldsTheSameAsTheText) {
  const TemporaryFolder folder;
  write_mesh(tetrahedron(), folder / "a.gltf");
  write_mesh(tetrahedron(), folder / "a.glb");
  const std::string glb = bytes_of(folder / "a.glb");
  const auto number_at = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, glb.data() + at, 4);
    return value;
  };
  ASSERT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_EQ(number_at(4), 2u);
  EXPECT_EQ(number_at(8), glb.size());
  const std::size_t json_bytes = number_at(12);
  ASSERT_EQ(glb.substr(16, 4), "JSON");
  auto document = nlohmann::json::parse(glb.substr(20, json_bytes));
  EXPECT_EQ(number_at(20 + json_bytes), document["buffers"][0]["byteLength"]);  // 4 * 12 + 12 * 4 needs no padding
  EXPECT_EQ(glb.substr(24 + json_bytes, 4), std::string("BIN\0", 4));
  const auto color = document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"];
  EXPECT_NEAR(color[0], 0.5776, 1e-4);  // sRGB 200 as linear light, IEC 61966-2-1
  EXPECT_NEAR(color[2], 5 / 255.0 / 12.92, 1e-6);
  auto text = nlohmann::json::parse(bytes_of(folder / "a.gltf"));
  text["buffers"][0].erase("uri");
  EXPECT_EQ(text, document);
}

}  // namespace
}  // namespace isostack
