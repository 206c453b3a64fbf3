#include <cmath>
#include <nlohmann/json.hpp>

#include "io/meshes/read_mesh.h"
#include "io/meshes/write_mesh.h"
#include "tests/io/io_support.h"

namespace isostack::testing {
namespace {

/// An octahedron with outward faces, far enough from the origin to show frame mistakes.
TriangleMesh octahedron() {
  TriangleMesh mesh;
  const Eigen::Vector3d centre(100.125, -50.5, 800.25);
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      const Eigen::Vector3d direction = sign * Eigen::Vector3d::Unit(axis);
      mesh.vertices_mm.push_back(centre + 10 * direction);
      mesh.normals.push_back(direction);
    }
  for (int octant = 0; octant < 8; ++octant) {
    const int x = octant & 1, y = octant >> 1 & 1, z = octant >> 2 & 1;
    const bool even = (x + y + z) % 2 == 0;
    mesh.triangles.push_back(even ? Eigen::Vector3i(x, 2 + y, 4 + z) : Eigen::Vector3i(2 + y, x, 4 + z));
  }
  return mesh;
}

/// By the divergence theorem; positive when faces point outwards.
double volume_mm3(const TriangleMesh& mesh) {
  double six_volumes = 0;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices_mm[static_cast<std::size_t>(t[0])],
                          &b = mesh.vertices_mm[static_cast<std::size_t>(t[1])],
                          &c = mesh.vertices_mm[static_cast<std::size_t>(t[2])];
    six_volumes += a.cross(b).dot(c);
  }
  return six_volumes / 6;
}

class MeshFiles : public ::testing::TestWithParam<const char*> {};

TEST_P(MeshFiles, RoundTripKeepsTheClosedSurface) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("octahedron") + GetParam());
  write_mesh(octahedron(), path);
  const TriangleMesh read = read_mesh(path);
  EXPECT_EQ(read.name, "octahedron");
  ASSERT_EQ(read.vertices_mm.size(), 6u);  // corners of equal place are one vertex
  EXPECT_EQ(read.triangles.size(), 8u);
  // 4/3 r^3; single precision keeps 1e-4 mm at 800 mm, over a surface of 350 mm^2
  EXPECT_NEAR(volume_mm3(read), 4.0 / 3 * 1000, 0.05);
  EXPECT_LT((read.vertices_mm[0] - octahedron().vertices_mm[0]).cwiseAbs().minCoeff(), 1e-4);
}

TEST_P(MeshFiles, NormalsComeBackUnlessTheFormatHasNone) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("octahedron") + GetParam());
  write_mesh(octahedron(), path);
  const TriangleMesh read = read_mesh(path);
  if (std::string(GetParam()) == ".stl") {
    EXPECT_TRUE(read.normals.empty());
    return;
  }
  ASSERT_EQ(read.normals.size(), 6u);
  const Eigen::Vector3d centre(100.125, -50.5, 800.25);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_GT(read.normals[i].dot((read.vertices_mm[i] - centre).normalized()), 0.9999);  // single precision
}

TEST_P(MeshFiles, TruncationNeverCrashes) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("octahedron") + GetParam());
  write_mesh(octahedron(), path);
  const std::string whole = bytes_of(path);
  int refused = 0, tried = 0;
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    write_bytes(path, whole.substr(0, length));
    ++tried;
    try {
      EXPECT_LE(read_mesh(path).triangles.size(), 8u);  // text may end after a whole face
    } catch (const InputError& error) {
      ++refused;
      EXPECT_NE(std::string(error.what()).find("octahedron"), std::string::npos);
    }
  }
  EXPECT_GT(refused, tried / 2);
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshFiles, ::testing::Values(".stl", ".ply", ".obj", ".vtp"),
                         [](const auto& format) { return std::string(format.param).substr(1); });

TEST(MeshFilesObj, SeamsAndPolygonsBecomeOneTriangleMesh) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.obj",
              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
              "f 1/1 2/2 3/3 4/4\nf 2/1 5/2 6/3 3/4\n");
  const TriangleMesh mesh = read_mesh(folder / "a.obj");
  EXPECT_EQ(mesh.vertices_mm.size(), 6u);
  EXPECT_EQ(mesh.triangles.size(), 4u);
}

TEST(MeshFilesGltf, IsUprightInMetres) {
  const TemporaryFolder folder;
  write_mesh(octahedron(), folder / "a.gltf");
  const auto document = nlohmann::json::parse(bytes_of(folder / "a.gltf"));
  EXPECT_EQ(document["asset"]["version"], "2.0");
  const auto& position =
      document["accessors"][document["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<int>()];
  EXPECT_EQ(position["count"], 6);
  // Left 100.125, superior 800.25, anterior 50.5 mm; single precision
  const double low[] = {0.090125, 0.79025, 0.0405}, high[] = {0.110125, 0.81025, 0.0605};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(position["min"][i].get<double>(), low[i], 1e-7);
    EXPECT_NEAR(position["max"][i].get<double>(), high[i], 1e-7);
  }
  EXPECT_EQ(document["accessors"][document["meshes"][0]["primitives"][0]["indices"].get<int>()]["count"], 24);
  EXPECT_EQ(document["buffers"][0]["byteLength"], 6 * 12 * 2 + 24 * 4);
  EXPECT_EQ(document["scenes"][0]["nodes"], nlohmann::json::array({0}));
}

TEST(MeshFilesErrors, MissingEmptyAndUnwritable) {
  const TemporaryFolder folder;
  EXPECT_NE(message_of([&] { read_mesh(folder / "a.stl"); }).find("no such file"), std::string::npos);
  for (const char* name : {"a.stl", "a.ply", "a.obj", "a.vtp"}) {
    write_bytes(folder / name, "");
    EXPECT_NE(message_of([&] { read_mesh(folder / name); }).find(name), std::string::npos);
  }
  for (const char* name : {"a.stl", "a.ply", "a.obj", "a.vtp", "a.gltf"})
    EXPECT_NE(message_of([&] { write_mesh(octahedron(), folder / "missing" / name); }).find("cannot be written"),
              std::string::npos);
}

TEST(MeshFilesRealData, HandIsRead) {
  const auto path = shared_data() / "meshes";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data";
  for (const auto& entry : std::filesystem::directory_iterator(path))
    if (entry.path().extension() == ".obj") {
      EXPECT_GT(read_mesh(entry.path()).triangles.size(), 1000u) << entry.path();
    }
}

}  // namespace
}  // namespace isostack::testing
