#include "io/contours/contours_edges.h"

#include <fmt/format.h>
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

/// In the plane x = 3: squares of 10 side by side, labels 1 and 2, that share an edge; the second one has a hole of 2.
/// `swapped` calls the other side left, `flipped` turns the normal.
std::string neighbours(bool swapped, bool flipped, bool added_d) {
  std::string text = fmt::format("1\n{} 0 0 {}\n10 11\n", flipped ? -1 : 1, (flipped ? -3 : 3) * (added_d ? -1 : 1));
  for (const auto& [y, z] : std::vector<std::pair<int, int>>{
           {0, 0}, {10, 0}, {10, 10}, {0, 10}, {20, 0}, {20, 10}, {14, 4}, {16, 4}, {16, 6}, {14, 6}})
    text += fmt::format("3 {} {}\n", y, z);
  const auto edge = [&](int from, int to, int left, int right) {
    if (swapped) std::swap(left, right);
    text += fmt::format("{} {} {} {}\n", from, to, left, right);
  };
  edge(0, 1, 1, 0);  // counter-clockwise seen from +x
  edge(2, 1, 2, 1);  // the shared edge, against label 1's way
  edge(2, 3, 1, 0);
  edge(0, 3, 0, 1);
  edge(1, 4, 2, 0);
  edge(4, 5, 2, 0);
  edge(5, 2, 2, 0);
  edge(6, 7, 0, 2);
  edge(7, 8, 0, 2);
  edge(8, 9, 0, 2);
  edge(6, 9, 2, 0);
  return text;
}

double area_mm2(const ContourSlice& slice) {
  double sum = 0;
  for (const Contour& contour : slice.contours) sum += signed_area_mm2(contour);
  return sum;
}

TEST(EdgeContours, ClosedCurvesTellWhichSideIsLeft) {
  const TemporaryFolder folder;
  for (const bool swapped : {false, true})
    for (const bool flipped : {false, true})
      for (const bool added_d : {false, true}) {
        write_bytes(folder / "a.contour", neighbours(swapped, flipped, added_d));
        ASSERT_TRUE(holds_contours(folder / "a.contour"));
        const std::vector<ContourStack> organs = read_contours(folder / "a.contour");
        ASSERT_EQ(organs.size(), 2u);
        const ContourSlice& first = organs[0].slices.at(0);
        const ContourSlice& second = organs[1].slices.at(0);
        ASSERT_EQ(first.contours.size(), 1u);
        ASSERT_EQ(second.contours.size(), 2u);
        EXPECT_NEAR(area_mm2(first), 100, 1e-9);
        EXPECT_NEAR(area_mm2(second), 100 - 4, 1e-9);
        EXPECT_TRUE(is_inside(first.contours, first.pose.world_to_slice({3, 5, 5})));
        EXPECT_TRUE(is_inside(second.contours, second.pose.world_to_slice({3, 12, 5})));
        EXPECT_NEAR(first.pose.slice_to_world(first.contours[0].points_mm[0]).x(), 3, 1e-12);
      }
}

TEST(EdgeContours, CurvesOfALabelThatMeetInAPointTouchButDoNotCross) {
  const TemporaryFolder folder;
  // two triangles of one label, tip to tip in vertex 0
  write_bytes(folder / "a.contour",
              "1\n0 0 1 0\n5 6\n0 0 0\n-2 4 0\n-2 -4 0\n2 -4 0\n2 4 0\n"
              "0 1 1 0\n1 2 1 0\n2 0 1 0\n0 3 1 0\n3 4 1 0\n4 0 1 0\n");
  const ContourSlice slice = read_contours(folder / "a.contour").at(0).slices.at(0);
  ASSERT_EQ(slice.contours.size(), 2u);
  EXPECT_NEAR(area_mm2(slice), 16, 1e-12);
}

TEST(EdgeContours, WrittenNeighboursShareTheirEdges) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.contour", neighbours(false, false, false));
  const std::vector<ContourStack> organs = read_contours(folder / "a.contour");
  write_contours(organs, folder / "b.contour");
  EXPECT_NE(bytes_of(folder / "b.contour").find("\n10 11\n"), std::string::npos) << bytes_of(folder / "b.contour");
  const std::vector<ContourStack> again = read_contours(folder / "b.contour");
  ASSERT_EQ(again.size(), 2u);
  for (std::size_t o = 0; o < 2; ++o) {
    EXPECT_NEAR(area_mm2(again[o].slices[0]), area_mm2(organs[o].slices[0]), 1e-9);
    EXPECT_EQ(again[o].slices[0].contours.size(), organs[o].slices[0].contours.size());
  }
}

TEST(EdgeContours, EveryTruncationAndDamageIsRefused) {
  const TemporaryFolder folder;
  const std::string whole = neighbours(false, false, false);
  for (std::size_t length = 0; length + 2 < whole.size(); length += 3) {
    write_bytes(folder / "a.contour", whole.substr(0, length));
    EXPECT_THROW(read_contours(folder / "a.contour"), Error) << length;
  }
  const auto refusal = [&](const std::string& from, const std::string& to) {
    write_bytes(folder / "a.contour", damaged(whole, from, to));
    return message_of([&] { read_contours(folder / "a.contour"); });
  };
  EXPECT_NE(refusal("10 11\n", "10 1000000000\n").find("line 3: the number of edges is 1000000000"), std::string::npos);
  EXPECT_NE(refusal("3 10 10", "3 10 inf").find("line 6: 'inf' is no number"), std::string::npos);
  EXPECT_NE(refusal("3 10 10", "4 10 10").find("plane 1: a vertex lies"), std::string::npos);
  EXPECT_NE(refusal("4 5 2 0", "4 4 2 0").find("plane 1: the boundary of label 2 ends at vertex 4"), std::string::npos);
  EXPECT_NE(refusal("4 5 2 0", "4 15 2 0").find("vertex 15 of 10"), std::string::npos);
}

}  // namespace
}  // namespace isostack
