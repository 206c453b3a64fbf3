#include "io/dicom/rtstruct.h"

#include <cmath>
#include <random>

#include "io/contours/contour_files.h"
#include "io/dicom/series_planes.h"
#include "io/dicom/write_dicom.h"
#include "io/inspect.h"
#include "tests/io/io_support.h"
#include "tests/io/rtstruct_support.h"

namespace isostack::testing {
namespace {

constexpr const char* closed = "CLOSED_PLANAR";

std::vector<Eigen::Vector3d> placed(const SlicePose& pose, const std::vector<Eigen::Vector2d>& points) {
  std::vector<Eigen::Vector3d> world;
  for (const Eigen::Vector2d& point : points) world.push_back(pose.slice_to_world(point));
  return world;
}

std::vector<Eigen::Vector2d> square(double low, double high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

SlicePose axial(double z_mm) {
  SlicePose pose;
  pose.origin_mm.z() = z_mm;
  return pose;
}

FileContour axial_square(double low, double high, double z_mm, const char* type = closed) {
  return {type, placed(axial(z_mm), square(low, high))};
}

double area_mm2(const ContourSlice& slice) {
  double sum = 0;
  for (const Contour& contour : slice.contours) sum += signed_area_mm2(contour);
  return sum;
}

ContourFile read_rois(const std::vector<FileRoi>& rois, const ReadOptions& options = {}) {
  const TemporaryFolder folder;
  write_bytes(folder / "rt.dcm", structure_set(rois).file());
  return read_rtstruct(folder / "rt.dcm", options);
}

bool warns_of(const ContourFile& file, const std::string& words) {
  return std::any_of(file.warnings.begin(), file.warnings.end(),
                     [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

TEST(Rtstruct, NamesTypesAndColoursComeAlong) {
  const ContourFile file =
      read_rois({{"Liver", "ORGAN", "200\\100\\50", {axial_square(0, 10, 5)}}, {"PTV", "PTV", "", {}}});
  ASSERT_EQ(file.organs.size(), 2u);
  EXPECT_EQ(file.organs[0].name, "Liver");
  EXPECT_EQ(file.organs[0].roi_type, "ORGAN");
  EXPECT_EQ(file.organs[0].color, (Color{200, 100, 50}));
  EXPECT_EQ(file.organs[1].name, "PTV");
  EXPECT_TRUE(file.organs[1].slices.empty());
  EXPECT_TRUE(warns_of(file, "PTV: it has no contours"));
  ASSERT_EQ(file.organs[0].slices.size(), 1u);
  EXPECT_NEAR(area_mm2(file.organs[0].slices[0]), 100, 1e-9);
  EXPECT_NEAR(file.organs[0].slices[0].pose.origin_mm.z(), 5, 1e-12);
  EXPECT_EQ(file.organs[0].slices[0].size_pixels, Eigen::Vector2i(0, 0));
}

TEST(Rtstruct, HolesAsLoopsByXorAndByKeyholeEncloseTheSame) {
  const std::vector<Eigen::Vector2d> keyhole = {{0, 0},  {20, 0},  {20, 20}, {0, 20}, {0, 5}, {5, 5},
                                                {5, 15}, {15, 15}, {15, 5},  {5, 5},  {0, 5}};
  const ContourFile file = read_rois(
      {{"loops", "", "", {axial_square(0, 20, 0), axial_square(5, 15, 0)}},
       {"xor", "", "", {axial_square(0, 20, 0, "CLOSEDPLANAR_XOR"), axial_square(5, 15, 0, "CLOSEDPLANAR_XOR")}},
       {"keyhole", "", "", {{closed, placed(axial(0), keyhole)}}}});
  for (const ContourStack& organ : file.organs) {
    ASSERT_EQ(organ.slices.size(), 1u) << organ.name;
    ASSERT_EQ(organ.slices[0].contours.size(), 2u) << organ.name;
    EXPECT_NEAR(area_mm2(organ.slices[0]), 300, 1e-9) << organ.name;
    EXPECT_FALSE(is_inside(organ.slices[0].contours, organ.slices[0].pose.world_to_slice({10, 10, 0})));
  }
  EXPECT_TRUE(warns_of(file, "keyhole: contours that cross"));
}

TEST(Rtstruct, OverlapIsAHoleUnlessContoursAreUnited) {
  const std::vector<FileRoi> rois = {{"A", "", "", {axial_square(0, 10, 0), axial_square(5, 15, 0)}}};
  EXPECT_NEAR(area_mm2(read_rois(rois).organs[0].slices[0]), 150, 1e-9);
  EXPECT_NEAR(area_mm2(read_rois(rois, {.unite_contours = true}).organs[0].slices[0]), 175, 1e-9);
}

TEST(Rtstruct, PointsAndOpenContoursAreLeftOutWithANote) {
  const ContourFile file = read_rois({{"A",
                                       "",
                                       "",
                                       {axial_square(0, 10, 0),
                                        {"POINT", {{1, 2, 3}}},
                                        axial_square(0, 5, 3, "OPEN_PLANAR"),
                                        axial_square(0, 5, 6, "OPEN_NONPLANAR"),
                                        {closed, {{0, 0, 9}, {1, 0, 9}}},
                                        {closed, {}}}}});
  EXPECT_EQ(file.organs[0].slices.size(), 1u);
  for (const char* words :
       {"1 POINT", "1 OPEN_PLANAR", "1 OPEN_NONPLANAR", "1 CLOSED_PLANAR of fewer than three points",
        "1 of its contours left out, for their coordinates are missing"})
    EXPECT_TRUE(warns_of(file, words)) << words;
}

TEST(Rtstruct, ObliqueContoursLieInOnePlaneEachThoughTheirDirectionIsUncertain) {
  // A large contour, and a tiny one whose own direction is lost in rounding to 0.01 mm.
  const auto rounded = [](std::vector<Eigen::Vector3d> points) {
    for (Eigen::Vector3d& point : points) point = (point * 100).array().round() / 100;
    return points;
  };
  SlicePose next = oblique_pose();
  next.origin_mm += 4 * next.normal();
  const ContourFile file = read_rois({{"A",
                                       "",
                                       "",
                                       {{closed, rounded(placed(oblique_pose(), square(0, 0.1)))},
                                        {closed, rounded(placed(oblique_pose(), square(10, 60)))},
                                        {closed, rounded(placed(next, square(0, 50)))}}}});
  const auto& slices = file.organs[0].slices;
  ASSERT_EQ(slices.size(), 2u);
  EXPECT_EQ(slices[0].contours.size() + slices[1].contours.size(), 3u);
  EXPECT_TRUE(are_parallel(slices[0].pose, oblique_pose(), 1e-3));  // 0.01 mm over 50 mm
  EXPECT_TRUE(are_parallel(slices[0].pose, slices[1].pose, 1e-12));
  const double gap_mm = (slices[1].pose.origin_mm - slices[0].pose.origin_mm).dot(slices[0].pose.normal());
  EXPECT_NEAR(std::abs(gap_mm), 4, 0.02);
}

TEST(Rtstruct, ContoursThatAreNotPlanarAreLeftOut) {
  auto bent = placed(axial(0), square(0, 30));
  bent[2].z() += 5;
  const ContourFile file = read_rois({{"A", "", "", {axial_square(0, 10, 3), {closed, bent}}}});
  EXPECT_EQ(file.organs[0].slices.size(), 1u);
  EXPECT_TRUE(warns_of(file, "A: 1 of its contours left out, for they do not lie in a plane"));
}

TEST(Rtstruct, SkippedPlanesAreUnknownMissingOnesAreAbsent) {
  FileRoi body{"body", "", "", {}}, sparse{"sparse", "", "", {}}, parted{"parted", "", "", {}};
  for (int i = 0; i < 13; ++i) {
    body.contours.push_back(axial_square(0, 50, 3.0 * i));
    if (i % 3 == 0) sparse.contours.push_back(axial_square(0, 10, 3.0 * i));
    if (i < 5 || i > 7) parted.contours.push_back(axial_square(0, 10, 3.0 * i));
  }
  const ContourFile file = read_rois({body, sparse, parted});
  EXPECT_EQ(file.organs[1].slices.size(), 5u);
  EXPECT_EQ(file.organs[2].slices.size(), 13u);
  EXPECT_TRUE(file.organs[2].slices[6].contours.empty());
  EXPECT_TRUE(warns_of(file, "parted: taken as absent on 3 planes"));
}

TEST(Rtstruct, NamesInOtherCharacterSetsAndEqualNames) {
  const TemporaryFolder folder;
  DicomBytes set = structure_set({{"Milz \xfc", "", "", {}}, {"A", "", "", {}}, {"A", "", "", {}}, {"", "", "", {}}});
  write_bytes(folder / "rt.dcm", set.text(0x00080005, "CS", "ISO_IR 100").file());
  const ContourFile file = read_rtstruct(folder / "rt.dcm");
  EXPECT_EQ(file.organs[0].name, "Milz \xc3\xbc");
  EXPECT_EQ(file.organs[2].name, "A (2)");
  EXPECT_EQ(file.organs[3].name, "ROI 13");
  write_rtstruct(file.organs, folder / "again.dcm");
  EXPECT_EQ(read_rtstruct(folder / "again.dcm").organs[0].name, file.organs[0].name);
}

/// Contours on the planes of oblique_stack, referring to it.
struct WithSeries : ::testing::Test {
  void SetUp() override {
    write_dicom_series(oblique_stack({0, 2, 4, 6, 8, 10}), folder.path(), {.seed = 3});
    options.like = folder.path();
    organ = {.name = "organ", .slices = series_planes(options), .color = Color{1, 2, 3}, .roi_type = "ORGAN"};
    for (const std::size_t i : {1, 2, 3}) {
      Contour contour{.points_mm = {{0.1, 0.2}, {3.3, 0.4}, {2.5, 3.75}}, .depth = 0};
      organ.slices[i].contours.push_back(contour);
    }
  }
  TemporaryFolder folder;
  WriteOptions options;
  ContourStack organ;
};

using RtstructWithSeries = WithSeries;

TEST_F(RtstructWithSeries, WhatIsWrittenComesBackOnTheImagesPlanes) {
  write_rtstruct({organ}, folder / "rt.dcm", options);
  const ContourFile file = read_rtstruct(folder / "rt.dcm");
  EXPECT_TRUE(file.warnings.empty()) << file.warnings.front();
  const ContourStack& read = file.organs.at(0);
  EXPECT_EQ(read.color, organ.color);
  EXPECT_EQ(read.roi_type, organ.roi_type);
  ASSERT_EQ(read.slices.size(), 5u);  // three with contours and the nearest image beyond each end
  EXPECT_TRUE(read.slices.front().contours.empty());
  EXPECT_TRUE(read.slices.back().contours.empty());
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(read.slices[i].name, organ.slices[i].name);
    EXPECT_EQ(read.slices[i].size_pixels, Eigen::Vector2i(7, 5));
    EXPECT_LT((read.slices[i].pose.origin_mm - organ.slices[i].pose.origin_mm).norm(), 1e-3);
    if (read.slices[i].contours.empty()) continue;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_LT((read.slices[i].pose.slice_to_world(read.slices[i].contours[0].points_mm[k]) -
                 organ.slices[i].pose.slice_to_world(organ.slices[i].contours[0].points_mm[k]))
                    .norm(),
                1.1e-3);  // plane heights within 1 µm are those of the image
  }
}

TEST_F(RtstructWithSeries, ImagesElsewhereAreFoundWhenGiven) {
  std::filesystem::create_directory(folder / "elsewhere");
  const auto path = folder / "elsewhere/rt.dcm";
  write_rtstruct({organ}, path, options);
  const ContourFile alone = read_rtstruct(path);
  EXPECT_EQ(alone.organs[0].slices.size(), 3u);
  EXPECT_TRUE(warns_of(alone, "--images"));
  EXPECT_EQ(read_rtstruct(path, {.images = folder.path()}).organs[0].slices.size(), 5u);
}

TEST_F(RtstructWithSeries, NoPatientUnlessIdentified) {
  write_rtstruct({organ}, folder / "anonymous.dcm", options);
  EXPECT_EQ(bytes_of(folder / "anonymous.dcm").find("PHANTOM"), std::string::npos);
  options.identify = true;
  write_rtstruct({organ}, folder / "named.dcm", options);
  EXPECT_NE(bytes_of(folder / "named.dcm").find("PHANTOM"), std::string::npos);
  options.like.reset();
  EXPECT_NE(message_of([&] { write_rtstruct({organ}, folder / "x.dcm", options); }).find("--like"), std::string::npos);
}

TEST_F(RtstructWithSeries, EqualInputGivesEqualFilesAndOtherInputOtherUids) {
  write_rtstruct({organ}, folder / "a.dcm", options);
  write_rtstruct({organ}, folder / "b.dcm", options);
  EXPECT_EQ(bytes_of(folder / "a.dcm"), bytes_of(folder / "b.dcm"));
  organ.slices[1].contours[0].points_mm[0].x() += 0.001;
  write_rtstruct({organ}, folder / "b.dcm", options);
  EXPECT_NE(bytes_of(folder / "a.dcm").substr(0, 400), bytes_of(folder / "b.dcm").substr(0, 400));
}

TEST_F(RtstructWithSeries, InfoListsTheRois) {
  write_rtstruct({organ}, folder / "rt.dcm", options);
  const auto series = inspect(folder / "rt.dcm");
  ASSERT_EQ(series.size(), 1u);
  ASSERT_EQ(series[0].organs.size(), 1u);
  EXPECT_EQ(series[0].organs[0].name, "organ");
  EXPECT_EQ(series[0].organs[0].type, "ORGAN");
  EXPECT_EQ(series[0].organs[0].contour_count, 3u);
  EXPECT_EQ(series[0].organs[0].point_count, 9u);
}

TEST_F(RtstructWithSeries, DciodvfyFindsNoError) {
  if (std::system("command -v dciodvfy >/dev/null") != 0) GTEST_SKIP() << "dciodvfy (dicom3tools) is not installed";
  ContourStack empty{.name = "empty", .slices = {}};
  write_rtstruct({organ, empty}, folder / "rt.dcm", options);
  write_rtstruct({organ, empty}, folder / "alone.dcm");
  for (const char* name : {"rt.dcm", "alone.dcm"}) {
    const std::string command = "dciodvfy " + (folder / name).string() + " >" + (folder / "log").string() + " 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    const std::string log = bytes_of(folder / "log");
    EXPECT_NE(log.find("RTStructureSet"), std::string::npos) << log;
    EXPECT_EQ(log.find("Error"), std::string::npos) << log;
  }
}

TEST_F(RtstructWithSeries, DamageIsRefusedOrReadNeverACrash) {
  write_rtstruct({organ, organ}, folder / "rt.dcm", options);
  const std::string whole = bytes_of(folder / "rt.dcm");
  std::filesystem::create_directory(folder / "other");
  const auto survives = [&](const std::string& bytes) {
    write_bytes(folder / "other/rt.dcm", bytes);
    try {
      read_rtstruct(folder / "other/rt.dcm");
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("rt.dcm"), std::string::npos) << error.what();
    }
  };
  for (std::size_t length = 0; length < whole.size(); length += 7) survives(whole.substr(0, length));
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    std::string flipped = whole;
    for (int k = 0; k < 3; ++k) flipped[random() % flipped.size()] = static_cast<char>(random());
    survives(flipped);
  }
}

TEST(Rtstruct, AllPlainEncodingsAreRead) {
  const TemporaryFolder folder;
  const DicomBytes set = structure_set({{"A", "", "1\\2\\3", {axial_square(0, 10, 0)}}});
  for (const DicomBytes::Encoding encoding : {DicomBytes::Encoding{true, false}, {false, false}, {true, true}}) {
    write_bytes(folder / "rt.dcm", set.file(encoding));
    EXPECT_NEAR(area_mm2(read_rtstruct(folder / "rt.dcm").organs.at(0).slices.at(0)), 100, 1e-9);
  }
}

TEST(Rtstruct, AbsurdContoursAreLeftOutAndMissingListsRefused) {
  const TemporaryFolder folder;
  FileContour endless = axial_square(0, 10, 0);
  for (int i = 0; i < 100'000; ++i) endless.points_mm.push_back({0, 0, 0});
  FileContour no_number = axial_square(0, 10, 3);
  no_number.points_mm[1].x() = std::nan("");
  const DicomBytes set = structure_set({{"A", "", "", {endless, no_number, axial_square(0, 10, 6)}}});
  write_bytes(folder / "rt.dcm", set.file({.explicit_vr = false}));
  const ContourFile file = read_rtstruct(folder / "rt.dcm");
  EXPECT_EQ(file.organs[0].slices.size(), 1u);
  EXPECT_TRUE(warns_of(file, "more than 100000 points"));
  EXPECT_TRUE(warns_of(file, "coordinates are missing or damaged"));
  write_bytes(folder / "rt.dcm", DicomBytes(set).without(0x30060039).file({.explicit_vr = false}));
  EXPECT_TRUE(read_rtstruct(folder / "rt.dcm").organs.at(0).slices.empty());
  write_bytes(folder / "rt.dcm", DicomBytes(set).without(0x30060020).file({.explicit_vr = false}));
  EXPECT_NE(message_of([&] { read_rtstruct(folder / "rt.dcm"); }).find("no list of ROIs"), std::string::npos);
}

TEST(Rtstruct, WhatIsNoStructureSetIsSaidSo) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0}), folder.path());
  EXPECT_NE(message_of([&] { read_contours(folder / "slice_0001.dcm"); }).find("not a structure set"),
            std::string::npos);
  EXPECT_FALSE(holds_contours(folder / "slice_0001.dcm"));
  EXPECT_THROW(read_rois({}), InputError);
}

TEST(Rtstruct, RealFileComesBackExactly) {
  const auto path = shared_data() / "rtstruct/breast.dcm";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const TemporaryFolder folder;
  const ContourFile file = read_rtstruct(path);
  ASSERT_EQ(file.organs.size(), 10u);
  write_rtstruct(file.organs, folder / "again.dcm");
  const ContourFile again = read_rtstruct(folder / "again.dcm");
  ASSERT_EQ(again.organs.size(), 10u);
  for (std::size_t i = 0; i < 10; ++i) {
    const ContourStack &a = file.organs[i], &b = again.organs[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.color, b.color);
    EXPECT_EQ(a.roi_type, b.roi_type);
    ASSERT_EQ(a.slices.size(), b.slices.size());
    for (std::size_t s = 0; s < a.slices.size(); ++s) {
      ASSERT_EQ(a.slices[s].contours.size(), b.slices[s].contours.size());
      for (std::size_t c = 0; c < a.slices[s].contours.size(); ++c) {
        const auto &p = a.slices[s].contours[c].points_mm, &q = b.slices[s].contours[c].points_mm;
        ASSERT_EQ(p.size(), q.size());
        for (std::size_t k = 0; k < p.size(); ++k)
          EXPECT_LT((a.slices[s].pose.slice_to_world(p[k]) - b.slices[s].pose.slice_to_world(q[k])).norm(), 1e-3);
      }
    }
  }
}

TEST(Rtstruct, RealReferencesValidAndDangling) {
  const auto data = shared_data() / "rtstruct/oblique_ct";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no " << data;
  const ContourFile valid = read_rtstruct(data / "rt.dcm");
  EXPECT_EQ(valid.organs[0].slices.at(0).size_pixels, Eigen::Vector2i(512, 512));
  const ContourFile dangling = read_rtstruct(data / "non_existent_reference_rt.dcm");
  EXPECT_EQ(dangling.organs.size(), 4u);
  EXPECT_EQ(dangling.organs[0].slices.at(0).size_pixels, Eigen::Vector2i(0, 0));
  EXPECT_TRUE(warns_of(dangling, "not in its folder"));
}

}  // namespace
}  // namespace isostack::testing
