#include "io/dicom/dicom_series.h"

#include "io/dicom/write_dicom.h"
#include "io/inspect.h"
#include "io/read_slices.h"
#include "io/volumes/volume_files.h"
#include "tests/io/compressed_files.h"
#include "tests/io/io_support.h"

namespace isostack::testing {
namespace {

// Positions and cosines are written with 10 digits; a grey value is 5 per mm at most, and rounded.
constexpr float place_tolerance = 1;

/// Replaces `from` by `to`, of the same length, in a file.
void patch(const std::filesystem::path& path, const std::string& from, const std::string& to) {
  std::string bytes = bytes_of(path);
  const auto at = bytes.find(from);
  ASSERT_NE(at, std::string::npos);
  ASSERT_EQ(from.size(), to.size());
  write_bytes(path, bytes.replace(at, from.size(), to));
}

TEST(DicomSeries, ObliqueSlicesComeBackWhereTheyWere) {
  const TemporaryFolder folder;
  const SliceStack written = oblique_stack({0, 1.5, 4, 10});
  write_dicom_series(written, folder.path());
  const SliceStack read = read_slices(folder.path());
  ASSERT_EQ(read.slices.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const SlicePose &a = written.slices[i].pose, &b = read.slices[i].pose;
    EXPECT_LT((a.origin_mm - b.origin_mm).norm(), 1e-6);  // 10 digits of some 100 mm
    EXPECT_LT((a.x_axis - b.x_axis).norm() + (a.y_axis - b.y_axis).norm(), 1e-8);
    EXPECT_LT((a.spacing_mm - b.spacing_mm).norm(), 1e-9);
    EXPECT_TRUE((written.slices[i].pixels == read.slices[i].pixels).all());
  }
  expect_pixels_at_their_place(read, place_tolerance);
}

TEST(DicomSeries, GantryTiltShearsNothing) {
  const TemporaryFolder folder;
  const double shear = std::tan(18.5 * std::numbers::pi / 180);
  write_dicom_series(oblique_stack({0, 1, 5, 12}, {0, shear}), folder.path());
  const SliceStack read = read_slices(folder.path());
  expect_pixels_at_their_place(read, place_tolerance);
  EXPECT_TRUE(has_warning(read.warnings, "gantry tilt: the slices are stacked at 18.5 degrees"));
  EXPECT_TRUE(has_warning(read.warnings, "uneven gaps: 1 x 1.00 mm, 1 x 4.00 mm, 1 x 7.00 mm"));
  EXPECT_NEAR(inspect(folder.path()).front().tilt_deg, 18.5, 1e-6);  // positions of 10 digits
}

TEST(DicomSeries, OrderFollowsPositionsNotNumbersOrNames) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({6, 0, 2, 4}), folder.path());
  const SliceStack read = read_slices(folder.path());
  const std::vector<double> positions_mm = positions_along_normal_mm(read.slices);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(positions_mm[i] - positions_mm[0], 2.0 * static_cast<double>(i), 1e-6);
  EXPECT_EQ(read.slices.front().name, "slice_0002.dcm");
  EXPECT_TRUE(read.warnings.empty());
}

TEST(DicomSeries, RescaleIsApplied) {
  const TemporaryFolder folder;
  SliceStack stack = oblique_stack({0, 1});
  for (Slice& slice : stack.slices) slice.pixels = (slice.pixels / 100).round() * 2.5f - 1000;
  write_dicom_series(stack, folder.path(), {.rescale_slope = 2.5, .rescale_intercept = -1000});
  const SliceStack read = read_slices(folder.path());
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_LT((stack.slices[i].pixels - read.slices[i].pixels).abs().maxCoeff(), 1e-3f);  // floats of some 1000
}

TEST(DicomSeries, OneFileIsOneSlice) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0, 1, 2}), folder.path());
  const SliceStack read = read_slices(folder / "slice_0002.dcm");
  ASSERT_EQ(read.slices.size(), 1u);
  expect_pixels_at_their_place(read, place_tolerance);
}

TEST(DicomSeries, SameSeedGivesSameBytes) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0}), folder / "a", {.seed = 7});
  write_dicom_series(oblique_stack({0}), folder / "b", {.seed = 7});
  write_dicom_series(oblique_stack({0}), folder / "c", {.seed = 8});
  EXPECT_EQ(bytes_of(folder / "a/slice_0001.dcm"), bytes_of(folder / "b/slice_0001.dcm"));
  EXPECT_NE(bytes_of(folder / "a/slice_0001.dcm"), bytes_of(folder / "c/slice_0001.dcm"));
}

TEST(DicomSeries, ValuesBeyond16BitsAreRefused) {
  const TemporaryFolder folder;
  SliceStack stack = oblique_stack({0});
  stack.slices.front().pixels(2, 3) = 40000;
  EXPECT_NE(message_of([&] { write_dicom_series(stack, folder.path()); }).find("slice 1"), std::string::npos);
}

TEST(DicomSeries, SeriesAreChosenByNumberUidOrEnding) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0, 1}), folder / "a", {.seed = 1});
  write_dicom_series(oblique_stack({0, 1, 2}), folder / "b", {.seed = 2});
  const std::string message = message_of([&] { read_slices(folder.path()); });
  EXPECT_NE(message.find("2 series (1: CT, 2 slices of 7 x 5"), std::string::npos) << message;
  EXPECT_NE(message.find("--series"), std::string::npos);
  const std::string uid = inspect(folder.path())[1].series_uid;
  EXPECT_EQ(read_slices(folder.path(), {.series = "1"}).slices.size(), 2u);
  EXPECT_EQ(read_slices(folder.path(), {.series = uid}).slices.size(), 3u);
  EXPECT_EQ(read_slices(folder.path(), {.series = uid.substr(uid.size() - 6)}).slices.size(), 3u);
  EXPECT_NE(message_of([&] { read_slices(folder.path(), {.series = "nonsense"}); }).find("no series match 'nonsense'"),
            std::string::npos);
}

TEST(DicomSeries, AllSeriesMakeOneScene) {
  const TemporaryFolder folder;
  SliceStack crossing = oblique_stack({1});
  std::swap(crossing.slices[0].pose.x_axis, crossing.slices[0].pose.y_axis);
  crossing.slices[0].pose.y_axis = oblique_pose().normal();
  write_dicom_series(oblique_stack({0, 1}), folder / "short", {.seed = 1});
  write_dicom_series(crossing, folder / "long", {.seed = 2});
  const SliceStack scene = read_slices(folder.path(), {.series = "all"});
  EXPECT_EQ(scene.slices.size(), 3u);
  EXPECT_TRUE(has_warning(scene.warnings, "mixed orientations: 3 slices lie in 2 directions"));
}

TEST(DicomSeries, EqualFileNamesAreToldApart) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0}), folder / "a", {.seed = 1});
  write_dicom_series(oblique_stack({3}), folder / "b", {.seed = 1});
  const SliceStack read = read_slices(folder.path());
  ASSERT_EQ(read.slices.size(), 2u);
  EXPECT_EQ(read.slices[0].name, "slice_0001.dcm [1]");
  EXPECT_EQ(read.slices[1].name, "slice_0001.dcm [2]");
}

TEST(DicomSeries, GridOfAnEvenSeriesIsItsLattice) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0, 2, 4}), folder.path());
  const Grid grid = read_grid(folder.path());
  EXPECT_EQ(grid.size, Eigen::Vector3i(7, 5, 3));
  EXPECT_NEAR(grid.voxel_volume_mm3(), 0.75 * 1.25 * 2, 1e-6);
}

TEST(DicomSeriesErrors, MissingAndEmptyPaths) {
  const TemporaryFolder folder;
  EXPECT_NE(message_of([&] { read_slices(folder / "nowhere"); }).find("no such file"), std::string::npos);
  EXPECT_NE(message_of([&] { read_slices(folder.path()); }).find("the folder is empty"), std::string::npos);
  write_bytes(folder / "notes.txt", "no image");
  EXPECT_NE(message_of([&] { read_slices(folder.path()); }).find("no readable image"), std::string::npos);
}

TEST(DicomSeriesErrors, EveryTruncationIsNoticed) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0}), folder.path());
  const std::string whole = bytes_of(folder / "slice_0001.dcm");
  for (std::size_t length = 132; length < whole.size(); ++length) {
    write_bytes(folder / "slice_0001.dcm", whole.substr(0, length));
    EXPECT_THROW(read_slices(folder.path()), Error) << length << " of " << whole.size() << " bytes";
  }
  EXPECT_NE(message_of([&] { read_slices(folder.path()); }).find("slice_0001.dcm: "), std::string::npos);
}

TEST(DicomSeriesErrors, ADamagedFileOfManyIsLeftOutAndNamed) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0, 2, 4, 6, 8, 10}), folder.path());
  std::filesystem::resize_file(folder / "slice_0003.dcm", 900);
  const SliceStack stack = read_slices(folder.path());
  EXPECT_EQ(stack.slices.size(), 5u);
  EXPECT_TRUE(has_warning(stack.warnings, "damaged files: left out, so a slice may be missing: slice_0003.dcm: "));
  EXPECT_TRUE(has_warning(stack.warnings, "missing slices: "));
  expect_pixels_at_their_place(stack, 1);
  // The file itself is refused, and so is a folder with nothing else.
  EXPECT_THROW(read_slices(folder / "slice_0003.dcm"), InputError);
  for (int i : {1, 2, 4, 5, 6}) std::filesystem::remove(folder / ("slice_000" + std::to_string(i) + ".dcm"));
  EXPECT_NE(message_of([&] { read_slices(folder.path()); }).find("slice_0003.dcm: the DICOM file is cut off"),
            std::string::npos);
}

TEST(DicomSeriesErrors, PixelsThatCannotBeDecodedAreLeftOutAndNamed) {
  if (!can_compress_dicom()) GTEST_SKIP() << "gdcmconv (libgdcm-tools) is not installed";
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0, 2, 4, 6, 8}), folder / "plain");
  std::filesystem::create_directory(folder / "rle");
  for (const auto& entry : std::filesystem::directory_iterator(folder / "plain"))
    ASSERT_TRUE(compress_dicom(entry.path(), folder / "rle" / entry.path().filename(), "rle"));
  std::string bytes = bytes_of(folder / "rle" / "slice_0002.dcm");
  std::fill(bytes.end() - 60, bytes.end() - 8, '\x7f');  // literal runs that reach beyond the end
  write_bytes(folder / "rle" / "slice_0002.dcm", bytes);
  const SliceStack stack = read_slices(folder / "rle");
  EXPECT_EQ(stack.slices.size(), 4u);
  EXPECT_TRUE(
      has_warning(stack.warnings, "damaged files: left out, so a slice may be missing: slice_0002.dcm: its pixels"));
  EXPECT_TRUE(has_warning(stack.warnings, "uneven gaps: ") || has_warning(stack.warnings, "missing slices: "));
  expect_pixels_at_their_place(stack, 1);
  EXPECT_NE(message_of([&] { read_slices(folder / "rle" / "slice_0002.dcm"); }).find("cannot be decoded"),
            std::string::npos);
}

TEST(DicomSeriesErrors, TwoSlicesAtOnePlace) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0, 2, 2.0005}), folder.path());
  EXPECT_NE(message_of([&] { read_slices(folder.path()); }).find("same position as slice_0002.dcm"), std::string::npos);
}

TEST(DicomSeriesErrors, OtherMatrixSize) {
  const TemporaryFolder folder;
  SliceStack stack = oblique_stack({0, 2});
  stack.slices[1].pixels = stack.slices[1].pixels.leftCols(6).eval();
  write_dicom_series(stack, folder.path());
  const std::string message = message_of([&] { read_slices(folder.path()); });
  EXPECT_NE(message.find("slice_0002.dcm: the slice has 6 x 5 pixels, but slice_0001.dcm has 7 x 5"), std::string::npos)
      << message;
}

TEST(DicomSeriesErrors, MissingPoseIsNamed) {
  // Explicit VR little endian: group and element of the tag, then its type; the tag becomes a private one.
  const std::pair<std::string, std::string> tags[] = {{std::string("\x20\0\x32\0DS", 6), "position"},
                                                      {std::string("\x20\0\x37\0DS", 6), "orientation"},
                                                      {std::string("\x28\0\x30\0DS", 6), "pixel spacing"}};
  for (const auto& [tag, what] : tags) {
    const TemporaryFolder folder;
    write_dicom_series(oblique_stack({0, 2}), folder.path());
    std::string unused = tag;
    unused[2] = static_cast<char>(tag[2] + 1);
    patch(folder / "slice_0002.dcm", tag, unused);
    const std::string message = message_of([&] { read_slices(folder.path()); });
    EXPECT_NE(message.find("slice_0002.dcm: the slice has no " + what), std::string::npos) << message;
  }
}

TEST(DicomSeriesErrors, ColourIsRefused) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0}), folder.path());
  patch(folder / "slice_0001.dcm", std::string("\x28\0\x02\0US\x02\0\x01", 9),
        std::string("\x28\0\x02\0US\x02\0\x03", 9));
  EXPECT_NE(message_of([&] { read_slices(folder.path()); }).find("slice_0001.dcm: the image is coloured"),
            std::string::npos);
}

TEST(DicomSeriesWarnings, InvertedGreysAreTold) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0}), folder.path());
  patch(folder / "slice_0001.dcm", "MONOCHROME2", "MONOCHROME1");
  EXPECT_TRUE(has_warning(read_slices(folder.path()).warnings, "inverted greys: 1 slices"));
}

TEST(DicomSeriesRealData, Jpeg2000AbdomenIsDecoded) {
  const auto path = shared_data() / "abdomen_ct/dicom";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data";
  const SliceStack stack = read_slices(path);
  ASSERT_EQ(stack.slices.size(), 20u);
  const std::vector<double> positions_mm = positions_along_normal_mm(stack.slices);
  for (std::size_t i = 1; i < 20; ++i) EXPECT_NEAR(positions_mm[i] - positions_mm[i - 1], 2, 1e-9);
  EXPECT_TRUE(has_warning(stack.warnings, "overlapping slices: they are 3.00 mm thick and 2.00 mm apart"));
  EXPECT_EQ(stack.slices.front().pixels.minCoeff(), -1024);  // air, in HU
}

TEST(DicomSeriesRealData, TiltedHeadTellsTiltAndGaps) {
  const auto path = shared_data() / "head_ct_tilt";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data";
  const SliceStack stack = read_slices(path);
  EXPECT_TRUE(has_warning(stack.warnings, "gantry tilt: the slices are stacked at 18.5 degrees"));
  EXPECT_TRUE(has_warning(stack.warnings, "uneven gaps: 1 x 1.08 mm, 13 x 4.00 mm, 13 x 7.00 mm"));
  EXPECT_FALSE(has_warning(stack.warnings, "missing slices"));
}

TEST(DicomSeriesRealData, BadSeriesAreRefusedOrTold) {
  const auto path = shared_data() / "bad_dicom";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data";
  EXPECT_NE(message_of([&] { read_slices(path / "notavolume"); }).find("4 slices lie at 1 place(s), up to 4 at one"),
            std::string::npos);
  EXPECT_EQ(read_slices(path / "notavolume", {.phase = 4}).slices.front().name, "004.dcm");
  EXPECT_TRUE(has_warning(read_slices(path / "slicecount").warnings, "few slices: 2"));
  EXPECT_TRUE(has_warning(read_slices(path / "sliceincrement").warnings, "missing slices: "));
  EXPECT_TRUE(has_warning(read_slices(path / "gantrytilting").warnings, "gantry tilt: the slices are stacked at 14.0"));
}

TEST(DicomSeriesRealData, HeartOfTwoPhasesIsOneSceneForEach) {
  const auto path = shared_data() / "cardiac_mr/dicom";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data";
  EXPECT_NE(message_of([&] { read_slices(path, {.series = "all"}); }).find("told apart by TriggerTime"),
            std::string::npos);
  const SliceStack diastole = read_slices(path / "frame_000", {.series = "all"});
  const SliceStack first = read_slices(path, {.series = "all", .phase = 1});
  ASSERT_EQ(first.slices.size(), 11u);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_EQ(first.slices[i].pose.origin_mm, diastole.slices[i].pose.origin_mm);
    EXPECT_TRUE((first.slices[i].pixels == diastole.slices[i].pixels).all());
  }
}

}  // namespace
}  // namespace isostack::testing
