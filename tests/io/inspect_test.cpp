#include "io/inspect.h"

#include "io/contours/contour_files.h"
#include "io/dicom/write_dicom.h"
#include "io/meshes/write_mesh.h"
#include "tests/io/seg_support.h"
#include "tests/io/volume_support.h"

namespace isostack::testing {
namespace {

TEST(Inspect, DirectionLetters) {
  EXPECT_EQ(direction_letter({1, 0, 0}), 'L');
  EXPECT_EQ(direction_letter({-0.9, 0.1, 0.2}), 'R');
  EXPECT_EQ(direction_letter({0, 1, 0}), 'P');
  EXPECT_EQ(direction_letter({0, -1, 0}), 'A');
  EXPECT_EQ(direction_letter({0, 0, 1}), 'S');
  EXPECT_EQ(direction_letter({0, 0, -1}), 'I');
}

TEST(Inspect, DicomSeriesIsMeasured) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0, 2, 4, 9}), folder.path(), {.slice_thickness_mm = 1.5});
  const auto found = inspect(folder.path());
  ASSERT_EQ(found.size(), 1u);
  const SeriesSummary& series = found.front();
  EXPECT_EQ(series.number, 1);
  EXPECT_EQ(series.kind, "DICOM");
  EXPECT_EQ(series.modality, "CT");
  EXPECT_EQ(series.value_type, "int16");
  EXPECT_NE(series.encoding.find("Explicit VR Little Endian"), std::string::npos);
  EXPECT_EQ(series.slice_count, 4u);
  EXPECT_EQ(series.columns, 7);
  EXPECT_EQ(series.rows, 5);
  ASSERT_TRUE(series.gaps);
  EXPECT_NEAR(series.gaps->smallest_mm, 2, 1e-6);  // 10 digits are written
  EXPECT_NEAR(series.gaps->median_mm, 2, 1e-6);
  EXPECT_NEAR(series.gaps->largest_mm, 5, 1e-6);
  EXPECT_LT((series.extent_mm - Eigen::Vector3d(7 * 0.75, 5 * 1.25, 9)).norm(), 1e-6);
  EXPECT_LT((series.row_direction - oblique_pose().x_axis).norm(), 1e-8);
  EXPECT_TRUE(has_warning(series.warnings, "uneven gaps: 2 x 2.00 mm, 1 x 5.00 mm"));
}

TEST(Inspect, DamagedFilesAndRepetitionsAreToldNotThrown) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0, 2, 2}), folder.path());
  std::filesystem::resize_file(folder / "slice_0001.dcm", 900);
  const auto found = inspect(folder.path());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE(has_warning(found[0].warnings, "repeated positions: "));
  EXPECT_EQ(found[1].kind, "DICOM damaged");
  EXPECT_TRUE(has_warning(found[1].warnings, "slice_0001.dcm: "));
}

TEST(Inspect, SegmentsAreListed) {
  const TemporaryFolder folder;
  DicomBytes data = segmentation({{2, 108, other}, {1, 100, "###............"}, {1, 104, dot}});
  DicomBytes code = segment_item(2, "two");
  code.sequence(0x0062000f, {DicomBytes().text(0x00080104, "LO", "Spleen")});
  data.sequence(0x00620002, {segment_item(1, "one"), code, segment_item(3, "three")});
  write_bytes(folder / "a.dcm", data.file());
  const SeriesSummary summary = inspect(folder / "a.dcm").front();
  EXPECT_EQ(summary.kind, "DICOM SEG");
  EXPECT_EQ(summary.slice_count, 3u);
  ASSERT_TRUE(summary.gaps);
  EXPECT_NEAR(summary.gaps->median_mm, 4, 1e-9);
  ASSERT_EQ(summary.organs.size(), 3u);
  const std::size_t frames[] = {2, 1, 0}, voxels[] = {4, 1, 0};
  const char *names[] = {"one", "two", "three"}, *types[] = {"", "Spleen", ""};
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_EQ(summary.organs[s].number, static_cast<int>(s) + 1);
    EXPECT_EQ(summary.organs[s].name, names[s]);
    EXPECT_EQ(summary.organs[s].type, types[s]);
    EXPECT_EQ(summary.organs[s].frame_count, frames[s]);
    EXPECT_EQ(summary.organs[s].voxel_count, voxels[s]);
  }
  EXPECT_TRUE(summary.warnings.empty());
  write_bytes(folder / "a.dcm", segmentation({{1, 100, dot}, {1, 101, dot}, {1, 107.43, dot}}).file());
  const SeriesSummary uneven = inspect(folder / "a.dcm").front();
  EXPECT_EQ(uneven.slice_count, 3u);
  EXPECT_TRUE(has_warning(uneven.warnings, "uneven frames: "));
}

TEST(Inspect, SegmentsOfALabelMapAreCountedByValue) {
  const TemporaryFolder folder;
  const std::vector<TestFrame> frames = {{0, 104, "2.............."}, {0, 100, "112............"}};
  DicomBytes data = with_bytes(segmentation(frames), frames,
                               [](char pixel) { return static_cast<char>(pixel == '.' ? 0 : pixel - '0'); });
  data.text(0x00620001, "CS", "LABELMAP").text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.66.7");
  write_bytes(folder / "a.dcm", data.file());
  const std::vector<OrganSummary> organs = inspect(folder / "a.dcm").front().organs;
  ASSERT_EQ(organs.size(), 2u);
  EXPECT_EQ(organs[0].frame_count, 1u);
  EXPECT_EQ(organs[0].voxel_count, 2u);
  EXPECT_EQ(organs[1].frame_count, 2u);
  EXPECT_EQ(organs[1].voxel_count, 2u);
}

TEST(Inspect, VolumeMeshAndContours) {
  const TemporaryFolder folder;
  write_labels({.layers = {LabelVolume(oblique_grid())}, .segments = {}}, folder / "a.nii.gz");
  const SeriesSummary volume = inspect(folder / "a.nii.gz").front();
  EXPECT_EQ(volume.kind, "NIfTI");
  EXPECT_EQ(volume.value_type, "uint16");
  EXPECT_NEAR(volume.gaps->median_mm, 2.5, 1e-4);  // the pose is stored in single precision

  TriangleMesh mesh;
  mesh.vertices_mm = {{0, 0, 0}, {1, 0, 0}, {0, 2, 3}};
  mesh.triangles = {{0, 1, 2}};
  write_mesh(mesh, folder / "a.vtp");
  const SeriesSummary triangle = inspect(folder / "a.vtp").front();
  EXPECT_EQ(triangle.kind, "mesh");
  EXPECT_EQ(triangle.triangle_count, 1u);
  EXPECT_EQ(triangle.upper_mm, Eigen::Vector3d(1, 2, 3));

  ContourStack organ{"liver", {}};
  organ.slices.resize(2);
  organ.slices[1].pose.origin_mm.z() = 3;
  organ.slices[1].contours = {{{{0, 0}, {4, 0}, {0, 5}}, 0}};
  for (const char* name : {"b.vtp", "b.json"}) {
    write_contours({organ}, folder / name);
    const SeriesSummary contours = inspect(folder / name).front();
    EXPECT_EQ(contours.kind, "contours");
    EXPECT_EQ(contours.name, "liver");
    EXPECT_EQ(contours.slice_count, 2u);
    EXPECT_EQ(contours.contour_count, 1u);
    EXPECT_EQ(contours.point_count, 3u);
    EXPECT_LT((contours.upper_mm - Eigen::Vector3d(4, 5, 3)).norm(), 1e-12);
  }
}

TEST(InspectRealData, TiltedHead) {
  const auto path = shared_data() / "head_ct_tilt";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data";
  const SeriesSummary head = inspect(path).front();
  EXPECT_EQ(head.slice_count, 28u);
  EXPECT_NEAR(head.tilt_deg, 18.5, 0.05);
  // 1.14, 4.22 and 7.38 mm along z, times cos(18.5 degrees)
  EXPECT_NEAR(head.gaps->smallest_mm, 1.08, 0.005);
  EXPECT_NEAR(head.gaps->median_mm, 4.00, 0.005);
  EXPECT_NEAR(head.gaps->largest_mm, 7.00, 0.005);
  EXPECT_EQ(head.orientation, "LPS");
}

TEST(InspectRealData, HeartHasElevenSeries) {
  const auto path = shared_data() / "cardiac_mr/dicom/frame_000";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data";
  const auto found = inspect(path);
  EXPECT_EQ(found.size(), 11u);
  for (const SeriesSummary& series : found) EXPECT_EQ(series.modality, "MR");
}

}  // namespace
}  // namespace isostack::testing
