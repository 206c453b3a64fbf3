#include "io/volumes/metaimage.h"

#include <fmt/format.h>

#include "tests/io/volume_support.h"

namespace isostack::testing {
namespace {

constexpr double pose_tolerance_mm = 1e-9;  // 12 digits are written

/// Header of oblique_grid(); the matrix lists the direction of the first axis, then of the second, ...
std::string header(const std::string& file, const std::string& more = "") {
  const Grid grid = oblique_grid();
  std::string matrix, spacing, offset;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d direction = grid.index_to_world.linear().col(axis);
    spacing += fmt::format(" {:.12g}", direction.norm());
    offset += fmt::format(" {:.12g}", grid.index_to_world.translation()[axis]);
    for (int i = 0; i < 3; ++i) matrix += fmt::format(" {:.12g}", direction[i] / direction.norm());
  }
  return fmt::format(
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nTransformMatrix ={}\n"
      "Offset ={}\nElementSpacing ={}\nDimSize = 4 3 5\n{}ElementType = MET_SHORT\nElementDataFile = {}\n",
      matrix, offset, spacing, more, file);
}

std::string voxels() { return as_bytes(counted<std::int16_t>(oblique_grid())); }

void expect_oblique(const std::filesystem::path& path) {
  const Volume<float> read = read_volume(path);
  expect_same_grid(read.grid, oblique_grid(), pose_tolerance_mm);
  EXPECT_EQ(read.voxels, counted<float>(read.grid));
}

TEST(MetaImage, AttachedAndDetachedVoxels) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.mha", header("LOCAL") + voxels());
  expect_oblique(folder / "a.mha");
  write_bytes(folder / "b.raw", voxels());
  write_bytes(folder / "b.mhd", header("b.raw"));
  expect_oblique(folder / "b.mhd");
}

TEST(MetaImage, WithoutDirectionsTheAssumptionIsTold) {
  const TemporaryFolder folder;
  write_bytes(
      folder / "a.mha",
      "NDims = 3\nDimSize = 4 3 5\nElementSpacing = 0.5 2 3\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
          as_bytes(counted<std::uint8_t>(oblique_grid())));
  const SliceStack stack = read_slices(folder / "a.mha");
  EXPECT_TRUE(has_warning(stack.warnings, "no orientation: "));
  EXPECT_EQ(stack.slices.front().pose.spacing_mm, Eigen::Vector2d(0.5, 2));
}

TEST(MetaImage, OneImageIsOneSlice) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.mha", "NDims = 2\nDimSize = 3 2\nElementType = MET_UCHAR\nElementDataFile = LOCAL\nabcdef");
  const SliceStack stack = read_slices(folder / "a.mha");
  ASSERT_EQ(stack.slices.size(), 1u);
  EXPECT_EQ(stack.slices[0].pixels(1, 0), 'd');
}

TEST(MetaImageErrors, EveryTruncationIsNoticed) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.mha", header("LOCAL") + voxels());
  expect_truncations_noticed(folder / "a.mha");
}

TEST(MetaImageErrors, UnsupportedFilesAreNamed) {
  const TemporaryFolder folder;
  const auto message_for = [&](const std::string& text) {
    write_bytes(folder / "a.mha", text);
    return message_of([&] { read_volume(folder / "a.mha"); });
  };
  EXPECT_NE(message_for(header("LOCAL", "ElementNumberOfChannels = 3\n")).find("3 values per voxel"),
            std::string::npos);
  EXPECT_NE(message_for(header("LIST")).find("several files"), std::string::npos);
  EXPECT_NE(message_for(header("gone.raw")).find("gone.raw is missing"), std::string::npos);
}

}  // namespace
}  // namespace isostack::testing
