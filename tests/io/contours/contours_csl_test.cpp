#include "io/contours/contours_csl.h"

#include <gtest/gtest.h>

#include "io/contours/contour_files.h"
#include "tests/io/io_support.h"

namespace isostack {
namespace {

using testing::bytes_of;
using testing::damaged;
using testing::message_of;
using testing::TemporaryFolder;
using testing::write_bytes;

/// z = 5: a square of 10 with a hole of 4, in which label 2 has a square of 2, and label 2 beside it sharing an edge.
/// y = 0, a second plane across it: nothing.
constexpr const char* two_planes = R"(CSLC
2 3

1 16 4 0 0 2 -10

0 0 5
10 0 5
10 10 5
0 10 5
3 3 5
7 3 5
7 7 5
3 7 5
4 4 5
6 4 5
6 6 5
4 6 5
20 0 5
20 10 5
0 0 5
0 0 5

4 1 0 1 2 3
4h0 2 4 5 6 7
4 2 8 9 10 11
4 2 1 12 13 2

2 0 0 0 1 0 0
)";

double area_mm2(const ContourSlice& slice) {
  double sum = 0;
  for (const Contour& contour : slice.contours) sum += signed_area_mm2(contour);
  return sum;
}

TEST(Csl, HoldsLabelsAsOrgansWithHolesAndEmptyPlanes) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.csl", two_planes);
  ASSERT_TRUE(holds_contours(folder / "a.csl"));
  const std::vector<ContourStack> organs = read_contours(folder / "a.csl");
  ASSERT_EQ(organs.size(), 2u);
  EXPECT_EQ(organs[0].name, "1");
  EXPECT_EQ(organs[1].name, "2");
  ASSERT_EQ(organs[0].slices.size(), 2u);
  EXPECT_DOUBLE_EQ(area_mm2(organs[0].slices[0]), 100 - 16);  // the hole is label 1's, although it says 2
  EXPECT_DOUBLE_EQ(area_mm2(organs[1].slices[0]), 4 + 100);
  EXPECT_TRUE(organs[0].slices[1].contours.empty());
  const SlicePose& pose = organs[0].slices[0].pose;
  EXPECT_NEAR(pose.signed_distance_mm({3, 4, 5}), 0, 1e-12);
  EXPECT_EQ(pose.normal(), Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d corner = pose.slice_to_world(organs[1].slices[0].contours[1].points_mm[2]);
  EXPECT_NEAR(corner.z(), 5, 1e-12);
}

TEST(Csl, TakesEitherSignOfDAndHolesCountedFromOne) {
  const TemporaryFolder folder;
  std::string text = two_planes;
  text.replace(text.find("0 0 2 -10"), 9, "0 0 2 10");
  text.replace(text.find("4h0"), 3, "4h1");
  write_bytes(folder / "a.csl", text);
  const std::vector<ContourStack> organs = read_contours(folder / "a.csl");
  EXPECT_NEAR(organs[0].slices[0].pose.signed_distance_mm({3, 4, 5}), 0, 1e-12);
  EXPECT_DOUBLE_EQ(area_mm2(organs[0].slices[0]), 100 - 16);
}

TEST(Csl, LoopsThatTouchInAVertexNestByWhatTheyEnclose) {
  const TemporaryFolder folder;
  // A square of 10; a hole of 7.5 mm² that begins in its first corner; tip to tip with the square a triangle of 7.5.
  const std::string vertices = "0 0 5\n10 0 5\n10 10 5\n0 10 5\n4 1 5\n1 4 5\n14 11 5\n11 14 5\n";
  for (const char* hole : {"3 1 0 4 5", "3h0 1 0 4 5", "3h1 2 0 5 4", "3h0 1 4 5 0"})
    for (const char* square : {"4 1 0 1 2 3", "4 1 2 3 0 1", "4 1 1 0 3 2"}) {
      SCOPED_TRACE(std::string(hole) + ", " + square);
      write_bytes(folder / "a.csl",
                  "CSLC\n1 2\n\n1 8 3 0 0 1 -5\n\n" + vertices + "\n" + square + "\n" + hole + "\n3 1 2 6 7\n");
      std::vector<ContourStack> organs = read_contours(folder / "a.csl");
      ASSERT_EQ(organs.size(), 1u);
      EXPECT_NEAR(area_mm2(organs[0].slices[0]), 100 - 7.5 + 7.5, 1e-9);
      EXPECT_EQ(organs[0].slices[0].contours.at(1).depth, 1);
      EXPECT_EQ(organs[0].slices[0].contours.at(2).depth, 0);
      write_contours(organs, folder / "b.csl");
      organs = read_contours(folder / "b.csl");
      EXPECT_NEAR(area_mm2(organs.at(0).slices[0]), 100, 1e-9);
      write_contours(organs, folder / "c.contour");
      organs = read_contours(folder / "c.contour");
      EXPECT_NEAR(area_mm2(organs.at(0).slices[0]), 100, 1e-9);
    }
}

TEST(Csl, LabelsWithoutLoopsAreOrgansThatAreAbsent) {
  const TemporaryFolder folder;
  const std::string text = two_planes;
  const auto organs_with = [&](const std::string& count) {
    write_bytes(folder / "a.csl", damaged(text, "2 3\n", "2 " + count + "\n"));
    return read_contours(folder / "a.csl");
  };
  const std::vector<ContourStack> organs = organs_with("5");
  ASSERT_EQ(organs.size(), 4u);
  EXPECT_EQ(organs[3].name, "4");
  EXPECT_EQ(organs[3].slices.size(), 2u);
  EXPECT_EQ(point_count(organs[3]), 0u);
  for (const char* count : {"0", "1", "2", "3", "1000000000", "-7"}) EXPECT_EQ(organs_with(count).size(), 2u) << count;
}

TEST(Csl, RoundTripKeepsCurvesToTheLastDigit) {
  const TemporaryFolder folder;
  const SlicePose pose = testing::oblique_pose();
  ContourStack organ{.name = "ring", .slices = {}};
  ContourSlice slice{.name = "s", .pose = pose, .contours = {}};
  slice.contours = {{.points_mm = {{0, 0}, {9, 0.1}, {9, 9}, {0, 9}}},
                    {.points_mm = {{3, 3}, {6, 3}, {6.7, 6}, {3, 6}}}};
  orient_by_nesting(slice.contours);
  organ.slices.push_back(slice);
  organ.slices.push_back({.name = "empty", .pose = pose, .contours = {}});
  organ.slices.back().pose.origin_mm += 4 * pose.normal();
  write_contours({organ}, folder / "a.csl");
  const std::vector<ContourStack> read = read_contours(folder / "a.csl");
  ASSERT_EQ(read.size(), 1u);
  ASSERT_EQ(read[0].slices.size(), 2u);
  ASSERT_EQ(read[0].slices[0].contours.size(), 2u);
  EXPECT_TRUE(read[0].slices[1].contours.empty());
  EXPECT_EQ(read[0].slices[0].contours[1].depth, 1);
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::Vector3d before = pose.slice_to_world(slice.contours[c].points_mm[i]);
      const Eigen::Vector3d after = read[0].slices[0].pose.slice_to_world(read[0].slices[0].contours[c].points_mm[i]);
      EXPECT_LT((before - after).norm(), 1e-11);  // rounding of coordinates around 100
    }
}

TEST(Csl, EveryTruncationAndDamageIsRefusedWithItsLine) {
  const TemporaryFolder folder;
  const std::string whole = two_planes;
  const std::size_t end = whole.find("2 0 0 0 1 0 0");
  for (std::size_t length = 0; length < end; length += 3) {
    write_bytes(folder / "a.csl", whole.substr(0, length));
    EXPECT_THROW(read_contours(folder / "a.csl"), Error) << length;
  }
  const auto refusal = [&](const std::string& from, const std::string& to) {
    write_bytes(folder / "a.csl", damaged(whole, from, to));
    return message_of([&] { read_contours(folder / "a.csl"); });
  };
  EXPECT_NE(refusal("2 3\n", "1000000000 3\n").find("line 2: the number of planes is 1000000000"), std::string::npos);
  EXPECT_NE(refusal("16 4", "999999999 4").find("line 4: the number of vertices"), std::string::npos);
  EXPECT_NE(refusal("10 0 5", "10 nan 5").find("line 7: 'nan' is no number"), std::string::npos);
  EXPECT_NE(refusal("10 0 5", "10 0 6").find("plane 1: a vertex lies 1 mm off"), std::string::npos);
  EXPECT_NE(refusal("0 0 2 -10", "0 0 0 -10").find("no normal"), std::string::npos);
  EXPECT_NE(refusal("2 8 9 10 11", "2 8 9 10 99").find("vertex 99 of 16"), std::string::npos);
  EXPECT_NE(refusal("4h0", "4x0").find("neither a number"), std::string::npos);
  EXPECT_NE(refusal("4 1 0 1 2 3", "4 1 0 2 1 3").find("crosses itself"), std::string::npos);
}

}  // namespace
}  // namespace isostack
