#include <gtest/gtest.h>

#include "io/contours/contour_files.h"
#include "io/meshes/read_mesh.h"
#include "io/meshes/write_mesh.h"
#include "io/volumes/volume_files.h"
#include "tests/io/io_support.h"
#include "tests/support/convertible.h"

namespace isostack::testing_support {
namespace {

using testing::TemporaryFolder;
using Path = std::filesystem::path;

/// Writes a file of every format, converts it to every other and back, and calls check(there, back, from, to).
template <class Write, class Convert, class Check>
void for_each_pair(const std::vector<std::string>& formats, Write write, Convert convert, Check check) {
  const TemporaryFolder folder;
  for (const std::string& from : formats) {
    write(folder / ("a" + from));
    for (const std::string& to : formats) {
      convert(folder / ("a" + from), folder / ("b" + to));
      convert(folder / ("b" + to), folder / ("c" + from));
      check(folder / ("c" + from), from, to);
    }
  }
}

TEST(ConversionMatrix, MeshesKeepWhatBothFormatsHold) {
  const auto write = [](const Path& path) { write_mesh(octahedron(), path); };
  const auto convert = [](const Path& in, const Path& out) { write_mesh(read_mesh(in), out); };
  for_each_pair({".stl", ".ply", ".obj", ".vtp"}, write, convert,
                [](const Path& path, const auto& from, const auto& to) {
                  const TriangleMesh mesh = read_mesh(path);
                  ASSERT_EQ(mesh.triangles.size(), 8u) << from << to;
                  for (const Eigen::Vector3d& vertex : mesh.vertices_mm)
                    EXPECT_NEAR((vertex - Eigen::Vector3d(1, -2, 300)).norm(), 25, 1e-4)
                        << from << to;                         // single precision at 300
                  if (from == ".stl" || to == ".stl") return;  // it holds no more
                  EXPECT_EQ(mesh.name, "liver") << from << to;
                  EXPECT_EQ(mesh.color, octahedron().color) << from << to;
                  EXPECT_EQ(mesh.normals.size(), 6u) << from << to;
                });
}

TEST(ConversionMatrix, ContoursKeepWhatBothFormatsHold) {
  const auto write = [](const Path& path) { write_contours(two_organs(), path); };
  const auto convert = [](const Path& in, const Path& out) { write_contours(read_contours(in), out); };
  const auto has_names = [](const std::string& format) { return format != ".csl" && format != ".contour"; };
  const std::vector<std::string> formats = {".json", ".vtp", ".csl", ".contour", ".dcm"};
  for_each_pair(formats, write, convert, [&](const Path& path, const auto& from, const auto& to) {
    const std::vector<ContourStack> organs = read_contours(path);
    ASSERT_EQ(organs.size(), 2u) << from << to;
    for (std::size_t o = 0; o < 2; ++o) {
      ASSERT_EQ(organs[o].slices.size(), 3u) << from << to;
      const double side_mm = o == 0 ? 20 : 6;
      for (std::size_t k = 0; k < 3; ++k) {
        const ContourSlice& slice = organs[o].slices[k];
        ASSERT_EQ(slice.contours.size(), 1u) << from << to;
        // RTSTRUCT keeps 0.1 micrometre of 20 mm sides
        EXPECT_NEAR(signed_area_mm2(slice.contours[0]), side_mm * side_mm, 1e-4) << from << to;
        EXPECT_NEAR(slice.pose.slice_to_world(slice.contours[0].points_mm[0]).z(), 5.0 * static_cast<double>(k), 1e-4);
      }
      if (!has_names(from) || !has_names(to)) continue;
      EXPECT_EQ(organs[o].name, two_organs()[o].name) << from << to;
      EXPECT_EQ(organs[o].color, two_organs()[o].color) << from << to;
      EXPECT_EQ(organs[o].roi_type, two_organs()[o].roi_type) << from << to;
    }
  });
}

TEST(ConversionMatrix, OrgansWithoutContoursStayWhereFormatsHoldThem) {
  const auto write = [](const Path& path) {
    std::vector<ContourStack> organs = two_organs();
    organs.insert(organs.begin() + 1, ContourStack{.name = "nowhere", .slices = {}});
    organs.push_back(ContourStack{.name = "nothing", .slices = {}});
    write_contours(organs, path);
  };
  const auto convert = [](const Path& in, const Path& out) { write_contours(read_contours(in), out); };
  for_each_pair({".json", ".vtp", ".csl", ".dcm"}, write, convert,
                [](const Path& path, const auto& from, const auto& to) {
                  const std::vector<ContourStack> organs = read_contours(path);
                  ASSERT_EQ(organs.size(), 4u) << from << to;
                  for (const std::size_t o : {1u, 3u}) EXPECT_EQ(point_count(organs[o]), 0u) << from << to;
                  for (const std::size_t o : {0u, 2u}) EXPECT_EQ(point_count(organs[o]), 12u) << from << to;
                  if (from == ".csl" || to == ".csl") return;  // names are numbers there
                  EXPECT_EQ(organs[1].name, "nowhere") << from << to;
                  EXPECT_EQ(organs[3].name, "nothing") << from << to;
                });
}

TEST(ConversionMatrix, FilesOfNothingButEmptyOrgans) {
  const TemporaryFolder folder;
  for (const char* name : {"a.json", "a.vtp", "a.csl", "a.dcm"}) {
    write_contours({ContourStack{.name = "1", .slices = {}}}, folder / name);
    const std::vector<ContourStack> organs = read_contours(folder / name);
    ASSERT_EQ(organs.size(), 1u) << name;
    EXPECT_EQ(organs[0].name, "1") << name;
    EXPECT_EQ(point_count(organs[0]), 0u) << name;
  }
}

TEST(ConversionMatrix, VolumesKeepValuesTypeAndPose) {
  const auto write = [](const Path& path) { write_volume(ramp(), path); };
  const auto convert = [](const Path& in, const Path& out) { write_volume(read_stored_volume(in), out); };
  const std::vector<std::string> formats = {".nii", ".nii.gz", ".nrrd", ".mha"};
  for_each_pair(formats, write, convert, [](const Path& path, const auto& from, const auto& to) {
    const StoredVolume volume = read_stored_volume(path);
    EXPECT_EQ(volume.header.value_type, "int16") << from << to;
    EXPECT_EQ(volume.bytes, ramp().bytes) << from << to;
    // NIfTI's pose is in single precision
    EXPECT_TRUE(volume.header.grid.index_to_world.isApprox(ramp().header.grid.index_to_world, 1e-6)) << from << to;
  });
}

TEST(ConversionMatrix, LabelsKeepNamesWhereBothFormatsDo) {
  const auto write = [](const Path& path) { write_labels(two_labels(), path); };
  const auto convert = [](const Path& in, const Path& out) { write_labels(read_labels(in), out); };
  const std::vector<std::string> formats = {".seg.nrrd", ".nii.gz", ".nrrd", ".mha"};
  for_each_pair(formats, write, convert, [](const Path& path, const auto& from, const auto& to) {
    const LabelMap read = read_labels(path);
    EXPECT_EQ(read.layers.at(0).voxels, two_labels().layers[0].voxels) << from << to;
    if (from == ".mha" || to == ".mha") return;  // numbers only
    ASSERT_EQ(read.segments.size(), 2u) << from << to;
    EXPECT_EQ(read.segments[0].name, "liver") << from << to;
  });
}

}  // namespace
}  // namespace isostack::testing_support
