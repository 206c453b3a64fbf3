#include "io/contours/guide_points.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "io/contours/contour_files.h"
#include "tests/io/io_support.h"

namespace isostack {
namespace {

using testing::message_of;
using testing::TemporaryFolder;
using testing::write_bytes;

constexpr const char* header = "x\ty\tz\tcontour type\tframeID\tweight\ttime frame\n";

std::string row(const Eigen::Vector3d& point, const std::string& type, int slice, const std::string& frame = "0") {
  return fmt::format("{}\t{}\t{}\t{}\t{}\t1.0\t{}\n", point.x(), point.y(), point.z(), type, slice, frame);
}

/// A short-axis plane z = 0 (slice 1), a long-axis plane y = 0 (slice 2).
constexpr const char* slice_info =
    "a.dcm\tsliceID: "
    "\t1\tImagePositionPatient\t-50\t-50\t0\tImageOrientationPatient\t1\t0\t0\t0\t1\t0\tPixelSpacing\t1.5\t2\n"
    "b.dcm\tsliceID: "
    "\t2\tImagePositionPatient\t-50\t0\t-50\tImageOrientationPatient\t1\t0\t0\t0\t0\t1\tPixelSpacing\t1.5\t2\n";

/// A left ventricle: a half ball of radius 20, open at z = 0 where the mitral valve is; the points shuffled.
std::string half_ball() {
  std::vector<std::string> rows;
  for (int i = 0; i < 90; ++i) {
    const double angle = 2 * std::numbers::pi * i / 90;
    rows.push_back(row({20 * std::cos(angle), 20 * std::sin(angle), 0}, "SAX_LV_ENDOCARDIAL", 1));
  }
  for (int i = 1; i < 45; ++i) {
    const double angle = std::numbers::pi * i / 45;
    rows.push_back(row({20 * std::cos(angle), 0, -20 * std::sin(angle)}, "LAX_LV_ENDOCARDIAL", 2, "1.0"));
  }
  rows.push_back(row({20, 0, 0}, "MITRAL_VALVE", 2));
  rows.push_back(row({-20, 0, 0}, "MITRAL_VALVE", 2));
  rows.push_back(row({0, 0, -20}, "APEX_POINT", 2));
  std::shuffle(rows.begin(), rows.end(), std::mt19937(5));
  std::string text = header;
  for (const std::string& line : rows) text += line;
  return text;
}

TEST(GuidePoints, UnorderedPointsBecomeLoopsClosedAtTheValve) {
  const TemporaryFolder folder;
  write_bytes(folder / "GPFile_000.txt", half_ball());
  write_bytes(folder / "SliceInfoFile.txt", slice_info);
  ASSERT_TRUE(holds_contours(folder / "GPFile_000.txt"));
  const ContourFile file = read_contour_file(folder / "GPFile_000.txt");
  ASSERT_EQ(file.organs.size(), 1u);
  const ContourStack& organ = file.organs.front();
  EXPECT_EQ(organ.name, "LV endocardium");
  ASSERT_EQ(organ.slices.size(), 2u);
  // polygons of 90 corners on the circle: (90/2) sin(2π/90) r² and half of it
  const double disc_mm2 = 45 * std::sin(2 * std::numbers::pi / 90) * 400;
  EXPECT_NEAR(signed_area_mm2(organ.slices[0].contours.at(0)), disc_mm2, 1e-3);
  EXPECT_NEAR(signed_area_mm2(organ.slices[1].contours.at(0)), disc_mm2 / 2, 1e-3);
  EXPECT_EQ(organ.slices[0].name, "short axis 1");
  EXPECT_EQ(organ.slices[1].name, "long axis 2");
  // DICOM names the distance of rows first
  EXPECT_EQ(organ.slices[0].pose.spacing_mm, Eigen::Vector2d(2, 1.5));
  EXPECT_TRUE(file.warnings.empty());
}

TEST(GuidePoints, SeptumAndFreeWallAreOneLoop) {
  const TemporaryFolder folder;
  std::string text = header;
  for (double i = 0; i <= 20; ++i) {
    text += row({i, 0, 0}, "SAX_RV_SEPTUM", 1);
    if (i > 0 && i < 20) text += row({i, 10, 0}, "SAX_RV_FREEWALL", 1);
  }
  for (double i = 1; i <= 10; ++i) text += row({0, i, 0}, "SAX_RV_FREEWALL", 1) + row({20, i, 0}, "SAX_RV_FREEWALL", 1);
  write_bytes(folder / "GPFile.txt", text);
  write_bytes(folder / "SliceInfoFile.txt", slice_info);
  const ContourFile file = read_guide_points(folder / "GPFile.txt");
  ASSERT_EQ(file.organs.size(), 1u);
  EXPECT_EQ(file.organs[0].name, "RV endocardium");
  EXPECT_NEAR(signed_area_mm2(file.organs[0].slices.at(0).contours.at(0)), 200, 1e-9);
}

TEST(GuidePoints, AnEpicardiumOfOneVentricleIsLeftOutWithAWarning) {
  const TemporaryFolder folder;
  std::string text = half_ball();
  for (double i = 0; i < 9; ++i) text += row({30, i, 0}, "SAX_RV_EPICARDIAL", 1);
  write_bytes(folder / "GPFile.txt", text);
  write_bytes(folder / "SliceInfoFile.txt", slice_info);
  const ContourFile file = read_guide_points(folder / "GPFile.txt");
  EXPECT_EQ(file.organs.size(), 1u);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_NE(file.warnings[0].find("epicardium, short axis 1"), std::string::npos) << file.warnings[0];
}

TEST(GuidePoints, SaysWhatIsWrongAndWhere) {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& points) {
    write_bytes(folder / "GPFile.txt", points);
    return message_of([&] { read_guide_points(folder / "GPFile.txt"); });
  };
  EXPECT_NE(message(half_ball()).find("SliceInfoFile.txt"), std::string::npos);
  write_bytes(folder / "SliceInfoFile.txt", slice_info);
  EXPECT_NE(message(std::string(header) + "1\t2\tnan\tSAX_LV_ENDOCARDIAL\t1\n").find("line 2"), std::string::npos);
  EXPECT_NE(message(std::string(header) + "1\t2\n").find("line 2: the line is cut off"), std::string::npos);
  EXPECT_NE(message(header).find("no guide point"), std::string::npos);
  EXPECT_NE(message("some text\n").find("not a table of guide points"), std::string::npos);
  const std::string wall = "SAX_LV_ENDOCARDIAL";
  EXPECT_NE(message(header + row({1, 2, 9}, wall, 1)).find("9.0 mm off the plane"), std::string::npos);
  EXPECT_NE(message(header + row({1, 2, 0}, wall, 7)).find("pose of slice 7 is missing"), std::string::npos);
  EXPECT_NE(message(header + row({1, 2, 0}, wall, 1, "0") + row({2, 2, 0}, wall, 1, "9")).find("several time frames"),
            std::string::npos);
}

TEST(GuidePoints, OfAHeartMatchItsFittedSurfaces) {
#ifdef ISOSTACK_SHARED_DATA
  const std::filesystem::path file = std::filesystem::path(ISOSTACK_SHARED_DATA) / "cardiac_mr" / "GPFile_000.txt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
  const ContourFile read = read_contour_file(file);
  ASSERT_EQ(read.organs.size(), 3u);
  for (const ContourStack& organ : read.organs) EXPECT_EQ(organ.slices.size(), 8u) << organ.name;
  ASSERT_EQ(read.warnings.size(), 1u);  // the right ventricle's outflow tract is traced without the left one's wall
  EXPECT_NE(read.warnings[0].find("long axis 11"), std::string::npos);
  // within each slice the epicardium goes round both ventricles
  const std::vector<ContourSlice>& outer = read.organs[2].slices;
  for (std::size_t i = 0; i < 5; ++i) {
    double inside_mm2 = 0;
    for (const std::size_t ventricle : {0u, 1u})
      inside_mm2 += signed_area_mm2(read.organs[ventricle].slices[i].contours.at(0));
    EXPECT_GT(signed_area_mm2(outer[i].contours.at(0)), inside_mm2) << outer[i].name;
  }
#else
  GTEST_SKIP() << "the development data are absent";
#endif
}

}  // namespace
}  // namespace isostack
