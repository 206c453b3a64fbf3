#include "io/volumes/nifti.h"

#include <cstring>

#include "tests/io/volume_support.h"

namespace isostack::testing {
namespace {

// Poses are stored as floats: 1e-5 of some 100 mm.
constexpr double pose_tolerance_mm = 1e-4;

LabelMap labels_on(const Grid& grid) {
  LabelVolume labels(grid);
  labels.voxels = counted<std::uint16_t>(grid);
  return {.layers = {std::move(labels)}, .segments = {}};
}

template <class T>
void put(std::string& bytes, std::size_t at, std::initializer_list<T> values) {
  for (const T value : values) {
    std::memcpy(bytes.data() + at, &value, sizeof(T));
    at += sizeof(T);
  }
}

void patch_nifti(const std::filesystem::path& path, const std::function<void(std::string&)>& change) {
  std::string bytes = bytes_of(path);
  change(bytes);
  write_bytes(path, bytes);
}

void expect_round_trip(const std::string& name, const Grid& grid) {
  const TemporaryFolder folder;
  write_labels(labels_on(grid), folder / name);
  const Volume<float> read = read_volume(folder / name);
  expect_same_grid(read.grid, grid, pose_tolerance_mm);
  EXPECT_EQ(read.voxels, counted<float>(grid));
}

TEST(Nifti, LabelsComeBackPlainAndCompressed) {
  expect_round_trip("a.nii", oblique_grid());
  expect_round_trip("a.nii.gz", oblique_grid());
}

TEST(Nifti, LeftHandedGridKeepsItsOrder) {
  expect_round_trip("a.nii", oblique_grid(true));
  expect_round_trip("a.nii.gz", oblique_grid(true));
}

TEST(Nifti, QformAloneGivesTheSamePose) {
  for (const bool left_handed : {false, true}) {
    const TemporaryFolder folder;
    write_labels(labels_on(oblique_grid(left_handed)), folder / "a.nii");
    patch_nifti(folder / "a.nii", [](std::string& bytes) { put<std::int16_t>(bytes, 254, {0}); });
    const Volume<float> read = read_volume(folder / "a.nii");
    expect_same_grid(read.grid, oblique_grid(left_handed), pose_tolerance_mm);
    EXPECT_EQ(read.voxels, counted<float>(read.grid));
  }
}

TEST(Nifti, SformIsPreferredAndTheDifferenceTold) {
  const TemporaryFolder folder;
  write_labels(labels_on(oblique_grid()), folder / "a.nii");
  patch_nifti(folder / "a.nii", [](std::string& bytes) { put<float>(bytes, 268, {1000}); });  // qoffset_x
  expect_same_grid(read_grid(folder / "a.nii"), oblique_grid(), pose_tolerance_mm);
  EXPECT_TRUE(has_warning(read_slices(folder / "a.nii").warnings, "differing poses: "));
}

TEST(Nifti, WithoutPoseOnlyTheVoxelSizeIsKnown) {
  const TemporaryFolder folder;
  write_labels(labels_on(oblique_grid()), folder / "a.nii");
  patch_nifti(folder / "a.nii", [](std::string& bytes) { put<std::int16_t>(bytes, 252, {0, 0}); });
  const SliceStack stack = read_slices(folder / "a.nii");
  EXPECT_TRUE(has_warning(stack.warnings, "no pose: "));
  EXPECT_LT((stack.slices.front().pose.spacing_mm - Eigen::Vector2d(0.75, 1.25)).norm(), 1e-6);
}

TEST(Nifti, ShearedGridIsKeptByTheSform) {
  Grid grid = oblique_grid();
  grid.index_to_world.linear().col(2) += 0.5 * oblique_pose().y_axis;
  expect_round_trip("a.nii", grid);
}

TEST(Nifti, ScaleIsApplied) {
  const TemporaryFolder folder;
  write_labels(labels_on(oblique_grid()), folder / "a.nii");
  patch_nifti(folder / "a.nii", [](std::string& bytes) { put<float>(bytes, 112, {0.5f, -10}); });
  const Volume<float> read = read_volume(folder / "a.nii");
  for (std::size_t i = 0; i < read.voxels.size(); ++i) ASSERT_EQ(read.voxels[i], 0.5f * static_cast<float>(i + 1) - 10);
}

TEST(Nifti, SlicesKeepTheVolumesOrder) {
  for (const bool left_handed : {false, true}) {
    const TemporaryFolder folder;
    write_labels(labels_on(oblique_grid(left_handed)), folder / "a.nii");
    const SliceStack stack = read_slices(folder / "a.nii");
    ASSERT_EQ(stack.slices.size(), 5u);
    const Grid grid = oblique_grid(left_handed);
    for (int k = 0; k < 5; ++k) {
      const Slice& slice = stack.slices[static_cast<std::size_t>(k)];
      EXPECT_EQ(slice.pixels(1, 2), static_cast<float>(grid.offset(2, 1, k) + 1));
      EXPECT_LT((slice.pose.pixel_to_world({2, 1}) - grid.index_to_world * Eigen::Vector3d(2, 1, k)).norm(),
                pose_tolerance_mm);
    }
  }
}

TEST(Nifti, OneImageIsOneSlice) {
  Grid grid = oblique_grid();
  grid.size.z() = 1;
  const TemporaryFolder folder;
  write_labels(labels_on(grid), folder / "a.nii");
  patch_nifti(folder / "a.nii", [](std::string& bytes) {
    put<std::int16_t>(bytes, 40, {2});  // dim[0]
    for (const std::size_t row : {288, 304, 320}) put<float>(bytes, row, {0});
  });
  const SliceStack stack = read_slices(folder / "a.nii");
  ASSERT_EQ(stack.slices.size(), 1u);
  EXPECT_LT((stack.slices.front().pose.x_axis - oblique_pose().x_axis).norm(), 1e-6);
}

TEST(NiftiErrors, EveryTruncationIsNoticed) {
  const TemporaryFolder folder;
  write_labels(labels_on(oblique_grid()), folder / "a.nii");
  expect_truncations_noticed(folder / "a.nii");
}

TEST(NiftiErrors, TruncatedCompressedVoxelsAreNoticed) {
  const TemporaryFolder folder;
  write_labels(labels_on(oblique_grid()), folder / "a.nii.gz");
  const std::string whole = bytes_of(folder / "a.nii.gz");
  for (std::size_t length = 0; length + 16 < whole.size(); ++length) {  // gzip ends with marks and a checksum
    write_bytes(folder / "a.nii.gz", whole.substr(0, length));
    EXPECT_THROW(read_volume(folder / "a.nii.gz"), Error) << length << " of " << whole.size() << " bytes";
  }
}

TEST(NiftiErrors, ImpossibleHeadersAreNamed) {
  const TemporaryFolder folder;
  const auto message_with = [&](const std::function<void(std::string&)>& change) {
    write_labels(labels_on(oblique_grid()), folder / "a.nii");
    patch_nifti(folder / "a.nii", change);
    return message_of([&] { read_volume(folder / "a.nii"); });
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    return text.find("a.nii") != std::string::npos && text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(contains(message_with([](auto& b) {
                         put<std::int16_t>(b, 42, {30000, 30000, 30000});
                       }),
                       "the header claims"));
  EXPECT_TRUE(contains(message_with([](auto& b) { put<std::int16_t>(b, 42, {-4}); }), "the header claims"));
  EXPECT_TRUE(contains(message_with([](auto& b) { put<std::int16_t>(b, 40, {4, 4, 3, 2, 2}); }), "4 dimensions"));
  EXPECT_TRUE(contains(message_with([](auto& b) { put<std::int16_t>(b, 70, {128}); }), "voxel type"));
  EXPECT_TRUE(contains(message_with([](auto& b) { put<float>(b, 280, {NAN}); }), "not a number"));
  EXPECT_TRUE(contains(message_with([](auto& b) { put<float>(b, 280, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}); }), "not"));
}

TEST(NiftiErrors, UnwritableFolderIsNamed) {
  const std::string message = message_of([] { write_labels(labels_on(oblique_grid()), "/proc/nowhere/a.nii"); });
  EXPECT_NE(message.find("/proc/nowhere/a.nii: cannot be written"), std::string::npos) << message;
}

TEST(NiftiRealData, AbdomenLiesWhereItsHeaderSays) {
  const auto path = shared_data() / "abdomen_ct/ct.nii.gz";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data";
  const Volume<float> volume = read_volume(path);
  // The sform is diag(3, 3, 3) from (-177.956, 11.319, 94.302) in RAS, as nibabel reads it.
  EXPECT_EQ(volume.grid.size, Eigen::Vector3i(122, 101, 112));
  EXPECT_LT((volume.grid.index_to_world.linear() - Eigen::Vector3d(-3, -3, 3).asDiagonal().toDenseMatrix()).norm(),
            1e-6);
  EXPECT_LT(
      (volume.grid.index_to_world.translation() - Eigen::Vector3d(177.95632935, -11.31900024, 94.30175781)).norm(),
      1e-6);
  EXPECT_EQ(*std::min_element(volume.voxels.begin(), volume.voxels.begin() + 122 * 101), -1068);
}

}  // namespace
}  // namespace isostack::testing
