#include "io/contours/contour_files.h"

#include <functional>
#include <nlohmann/json.hpp>

#include "io/meshes/write_mesh.h"
#include "tests/io/io_support.h"

namespace isostack::testing {
namespace {

Contour circle(double radius_mm, bool reversed = false) {
  Contour contour;
  for (int i = 0; i < 40; ++i) {
    const double angle = (reversed ? -1 : 1) * 2 * std::numbers::pi * i / 40;
    contour.points_mm.emplace_back(20 + radius_mm * std::cos(angle), 15 + radius_mm * std::sin(angle));
  }
  return contour;
}

/// Two organs on oblique planes: one with a ring (outer curve and hole), one absent on its last slice.
std::vector<ContourStack> two_organs() {
  std::vector<ContourStack> organs(2);
  organs[0].name = "liver \"left\"";
  organs[1].name = "kidney";
  organs[0].color = Color{200, 10, 255};
  organs[0].roi_type = "ORGAN";
  for (ContourStack& organ : organs)
    for (int k = 0; k < 3; ++k) {
      ContourSlice& slice = organ.slices.emplace_back();
      slice.name = "slice " + std::to_string(k);
      slice.pose = oblique_pose();
      slice.pose.origin_mm += 4 * k * slice.pose.normal();
      slice.size_pixels = {60, 30};
      slice.contours = {circle(10), circle(4, true)};
      orient_by_nesting(slice.contours);
    }
  organs[1].slices[2].contours.clear();
  return organs;
}

class ContourFiles : public ::testing::TestWithParam<const char*> {};

TEST_P(ContourFiles, RoundTripKeepsEverything) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("a") + GetParam());
  const auto written = two_organs();
  write_contours(written, path);
  EXPECT_TRUE(holds_contours(path));
  const auto read = read_contours(path);
  ASSERT_EQ(read.size(), 2u);
  for (std::size_t organ = 0; organ < 2; ++organ) {
    EXPECT_EQ(read[organ].name, written[organ].name);
    EXPECT_EQ(read[organ].color, written[organ].color);
    EXPECT_EQ(read[organ].roi_type, written[organ].roi_type);
    ASSERT_EQ(read[organ].slices.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
      const ContourSlice &a = written[organ].slices[k], &b = read[organ].slices[k];
      EXPECT_EQ(a.name, b.name);
      EXPECT_EQ(a.size_pixels, b.size_pixels);
      EXPECT_LT((a.pose.pixel_to_world({7, 9}) - b.pose.pixel_to_world({7, 9})).norm(), 1e-9);  // doubles of 100 mm
      ASSERT_EQ(a.contours.size(), b.contours.size());
      for (std::size_t c = 0; c < a.contours.size(); ++c) {
        EXPECT_EQ(a.contours[c].depth, b.contours[c].depth);
        EXPECT_NEAR(signed_area_mm2(a.contours[c]), signed_area_mm2(b.contours[c]), 1e-9);
        ASSERT_EQ(a.contours[c].points_mm.size(), b.contours[c].points_mm.size());
        EXPECT_LT((a.contours[c].points_mm[5] - b.contours[c].points_mm[5]).norm(), 1e-9);
      }
    }
  }
}

TEST_P(ContourFiles, TruncationIsNoticed) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("a") + GetParam());
  write_contours(two_organs(), path);
  const std::string whole = bytes_of(path);
  for (std::size_t length = 0; length + 2 < whole.size(); length += 37) {
    write_bytes(path, whole.substr(0, length));
    EXPECT_THROW(read_contours(path), InputError) << length << " of " << whole.size() << " bytes";
  }
}

TEST_P(ContourFiles, UnwritableFolderIsNamed) {
  const std::string path = std::string("/proc/nowhere/a") + GetParam();
  EXPECT_NE(message_of([&] { write_contours(two_organs(), path); }).find(path + ": cannot be written"),
            std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Formats, ContourFiles, ::testing::Values(".vtp", ".json"),
                         [](const auto& format) { return std::string(format.param).substr(1); });

/// A document with one triangle, changed by the test.
nlohmann::json document() {
  return nlohmann::json::parse(R"({
    "format": "isostack-contours", "version": 1,
    "organs": [{"name": "liver", "slices": [{
      "name": "plane 7",
      "pose": {"origin_mm": [0, 0, 5], "x_axis": [1, 0, 0], "y_axis": [0, 1, 0], "spacing_mm": [1, 1]},
      "size_pixels": [10, 10],
      "contours": [{"points_mm": [[0, 0], [0, 4], [3, 0]]}]}]}]})");
}

TEST(ContourFilesJson, NestingAndOrientationAreComputed) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.json", document().dump());
  const auto organs = read_contours(folder / "a.json");
  EXPECT_NEAR(signed_area_mm2(organs[0].slices[0].contours[0]), 6, 1e-12);  // was clockwise
}

TEST(ContourFilesJson, RepeatedLastPointIsDropped) {
  const TemporaryFolder folder;
  auto json = document();
  json["organs"][0]["slices"][0]["contours"][0]["points_mm"].push_back({0, 0});
  write_bytes(folder / "a.json", json.dump());
  EXPECT_EQ(point_count(read_contours(folder / "a.json")[0]), 3u);
}

TEST(ContourFilesJson, EachMistakeIsNamed) {
  const TemporaryFolder folder;
  const auto message_with = [&](const std::function<void(nlohmann::json&, nlohmann::json&)>& change) {
    auto json = document();
    change(json, json["organs"][0]["slices"][0]);
    write_bytes(folder / "a.json", json.dump());
    return message_of([&] { read_contours(folder / "a.json"); });
  };
  const auto open = message_with([](auto&, auto& slice) { slice["contours"][0]["closed"] = false; });
  EXPECT_NE(open.find("a.json, slice plane 7: a contour is open"), std::string::npos) << open;
  const auto two = message_with([](auto&, auto& slice) { slice["contours"][0]["points_mm"].erase(0); });
  EXPECT_NE(two.find("slice plane 7: a contour has 2 points"), std::string::npos) << two;
  const auto eight = message_with([](auto&, auto& slice) {
    slice["contours"][0]["points_mm"] = {{0, 0}, {4, 4}, {4, 0}, {0, 4}};
  });
  EXPECT_NE(eight.find("slice plane 7: a contour crosses itself at (2.00, 2.00) mm"), std::string::npos) << eight;
  const auto skewed = message_with([](auto&, auto& slice) { slice["pose"]["y_axis"] = {1, 0, 0}; });
  EXPECT_NE(skewed.find("plane 7"), std::string::npos) << skewed;
  const auto short_point = message_with([](auto&, auto& slice) { slice["contours"][0]["points_mm"][0] = {1}; });
  EXPECT_NE(short_point.find("2 numbers"), std::string::npos) << short_point;
  EXPECT_NE(message_with([](auto& json, auto&) { json["version"] = 9; }).find("docs/formats.md"), std::string::npos);
  EXPECT_NE(message_with([](auto& json, auto&) { json["version"] = "one"; }).find("a.json"), std::string::npos);
  EXPECT_NE(message_with([](auto& json, auto&) { json["version"] = 1e300; }).find("docs/formats.md"),
            std::string::npos);
  const auto endless = message_with([](auto&, auto& slice) { slice["size_pixels"] = {1e300, 1}; });
  EXPECT_NE(endless.find("too large a number"), std::string::npos) << endless;
  EXPECT_NE(message_with([](auto&, auto& slice) { slice.erase("pose"); }).find("pose"), std::string::npos);
}

TEST(ContourFilesVtp, OpenPolylineIsNamed) {
  const TemporaryFolder folder;
  // A hand-written file: the polyline 0 1 2 does not return to 0.
  write_bytes(folder / "a.vtp", R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>
<FieldData>
<Array type="String" Name="organ_name" NumberOfTuples="1" format="ascii">107 0</Array>
<Array type="String" Name="slice_name" NumberOfTuples="1" format="ascii">112 55 0</Array>
<DataArray type="Int32" Name="slice_organ" NumberOfTuples="1" format="ascii">0</DataArray>
<DataArray type="Float64" Name="slice_origin_mm" NumberOfComponents="3" NumberOfTuples="1" format="ascii">0 0 0</DataArray>
<DataArray type="Float64" Name="slice_x_axis" NumberOfComponents="3" NumberOfTuples="1" format="ascii">1 0 0</DataArray>
<DataArray type="Float64" Name="slice_y_axis" NumberOfComponents="3" NumberOfTuples="1" format="ascii">0 1 0</DataArray>
<DataArray type="Float64" Name="slice_spacing_mm" NumberOfComponents="2" NumberOfTuples="1" format="ascii">1 1</DataArray>
<DataArray type="Int32" Name="slice_size_pixels" NumberOfComponents="2" NumberOfTuples="1" format="ascii">9 9</DataArray>
</FieldData>
<Piece NumberOfPoints="3" NumberOfVerts="0" NumberOfLines="1" NumberOfStrips="0" NumberOfPolys="0">
<CellData><DataArray type="Int32" Name="slice" format="ascii">0</DataArray></CellData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 1 1 0</DataArray></Points>
<Lines><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray></Lines>
</Piece></PolyData></VTKFile>)");
  const std::string message = message_of([&] { read_contours(folder / "a.vtp"); });
  EXPECT_NE(message.find("a.vtp, slice p7: a contour is open"), std::string::npos) << message;
}

TEST(ContourFilesVtp, MeshIsNotContours) {
  const TemporaryFolder folder;
  TriangleMesh mesh;
  mesh.vertices_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  write_mesh(mesh, folder / "a.vtp");
  EXPECT_FALSE(holds_contours(folder / "a.vtp"));
  EXPECT_NE(message_of([&] { read_contours(folder / "a.vtp"); }).find("not a contour file"), std::string::npos);
}

}  // namespace
}  // namespace isostack::testing
