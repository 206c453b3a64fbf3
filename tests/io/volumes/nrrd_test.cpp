#include "io/volumes/nrrd.h"

#include <fmt/format.h>
#include <zlib.h>

#include "tests/io/volume_support.h"

namespace isostack::testing {
namespace {

constexpr double pose_tolerance_mm = 1e-9;  // 12 digits are written

std::string vector_text(const Eigen::Vector3d& v) {
  return fmt::format("({:.12g},{:.12g},{:.12g})", v.x(), v.y(), v.z());
}

/// Header of oblique_grid() in a space whose axes are LPS times `signs`.
std::string header(const std::string& space, const Eigen::Vector3d& signs, const std::string& encoding = "raw",
                   const std::string& more = "") {
  const Eigen::Affine3d& map = oblique_grid().index_to_world;
  std::string directions;
  for (int axis = 0; axis < 3; ++axis) directions += " " + vector_text(signs.cwiseProduct(map.linear().col(axis)));
  return fmt::format(
      "NRRD0005\n# written by a test\ntype: short\ndimension: 3\nspace: {}\nsizes: 4 3 5\nspace directions:{}\n"
      "kinds: domain domain domain\nendian: little\nencoding: {}\nspace origin: {}\n{}",
      space, directions, encoding, vector_text(signs.cwiseProduct(map.translation())), more);
}

std::string voxels() { return as_bytes(counted<std::int16_t>(oblique_grid())); }

std::string gzipped(const std::string& bytes) {
  std::string result(1000 + bytes.size(), '\0');
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);  // 16: with gzip's header
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

void expect_oblique(const std::filesystem::path& path) {
  const Volume<float> read = read_volume(path);
  expect_same_grid(read.grid, oblique_grid(), pose_tolerance_mm);
  EXPECT_EQ(read.voxels, counted<float>(read.grid));
}

TEST(Nrrd, EverySpaceBecomesLps) {
  const TemporaryFolder folder;
  const std::pair<const char*, Eigen::Vector3d> spaces[] = {{"left-posterior-superior", {1, 1, 1}},
                                                            {"LPS", {1, 1, 1}},
                                                            {"right-anterior-superior", {-1, -1, 1}},
                                                            {"RAS", {-1, -1, 1}},
                                                            {"left-anterior-superior", {1, -1, 1}}};
  for (const auto& [space, signs] : spaces) {
    SCOPED_TRACE(space);
    write_bytes(folder / "a.nrrd", header(space, signs) + "\n" + voxels());
    expect_oblique(folder / "a.nrrd");
  }
}

TEST(Nrrd, CompressedAndDetachedVoxels) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.nrrd", header("LPS", {1, 1, 1}, "gzip") + "\n" + gzipped(voxels()));
  expect_oblique(folder / "a.nrrd");
  write_bytes(folder / "b.raw", voxels());
  write_bytes(folder / "b.nhdr", header("LPS", {1, 1, 1}, "raw", "data file: b.raw\n"));
  expect_oblique(folder / "b.nhdr");
  write_bytes(folder / "c.raw.gz", gzipped(voxels()));
  write_bytes(folder / "c.nhdr", header("LPS", {1, 1, 1}, "gzip", "data file: c.raw.gz\n"));
  expect_oblique(folder / "c.nhdr");
}

TEST(Nrrd, WithoutSpaceTheAssumptionIsTold) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.nrrd",
              "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 3 5\nspacings: 0.5 2 3\nencoding: raw\n\n" +
                  as_bytes(counted<std::uint8_t>(oblique_grid())));
  const SliceStack stack = read_slices(folder / "a.nrrd");
  EXPECT_TRUE(has_warning(stack.warnings, "no patient space: "));
  EXPECT_EQ(stack.slices.front().pose.spacing_mm, Eigen::Vector2d(0.5, 2));
  EXPECT_EQ(stack.slices.size(), 5u);
}

TEST(Nrrd, OneImageIsOneSlice) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.nrrd", "NRRD0004\ntype: uchar\ndimension: 2\nsizes: 3 2\nencoding: raw\n\nabcdef");
  const SliceStack stack = read_slices(folder / "a.nrrd");
  ASSERT_EQ(stack.slices.size(), 1u);
  EXPECT_EQ(stack.slices[0].pixels(1, 0), 'd');
}

TEST(NrrdErrors, EveryTruncationIsNoticed) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.nrrd", header("RAS", {-1, -1, 1}) + "\n" + voxels());
  expect_truncations_noticed(folder / "a.nrrd");
}

TEST(NrrdErrors, UnsupportedFilesAreNamed) {
  const TemporaryFolder folder;
  const auto message_for = [&](const std::string& text) {
    write_bytes(folder / "a.nrrd", text);
    return message_of([&] { read_volume(folder / "a.nrrd"); });
  };
  std::string four = header("LPS", {1, 1, 1}) + "\n" + voxels();
  four.replace(four.find("sizes: 4 3 5"), 12, "sizes: 4 3 5 1");
  EXPECT_NE(message_for(four).find("4 dimensions"), std::string::npos);
  EXPECT_NE(message_for(header("LPS", {1, 1, 1}, "bzip2") + "\n" + voxels()).find("'bzip2'"), std::string::npos);
  EXPECT_NE(message_for(header("sideways", {1, 1, 1}) + "\n" + voxels()).find("'sideways'"), std::string::npos);
  EXPECT_NE(message_for(header("LPS", {1, 1, 1}, "raw", "data file: b.raw\n")).find("b.raw is missing"),
            std::string::npos);
  EXPECT_NE(message_for("hello").find("a.nrrd"), std::string::npos);
}

TEST(NrrdRealData, SegmentationsLieOnTheirCt) {
  const auto path = shared_data() / "dicom_seg";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data";
  const Grid labels = read_grid(path / "liver_seg.nrrd"), ct = read_grid(path / "ct");
  expect_same_grid(labels, ct, 1e-4);  // spacing and origin are written with 6 decimals, over 512 pixels
}

}  // namespace
}  // namespace isostack::testing
