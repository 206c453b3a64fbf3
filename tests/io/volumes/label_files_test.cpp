#include <cstring>
#include <functional>

#include "io/volumes/volume_files.h"
#include "tests/io/label_support.h"

namespace isostack::testing {
namespace {

constexpr double exact = 1e-12;
constexpr double single_precision_mm = 1e-4;  // NIfTI-1 holds poses as floats

/// overlapping_organs() without the overlap.
LabelMap separate_organs() {
  LabelMap map = overlapping_organs();
  map.layers.pop_back();
  map.segments.pop_back();
  return map;
}

TEST(LabelFiles, SegNrrdKeepsEverything) {
  const TemporaryFolder folder;
  for (const char* name : {"a.seg.nrrd", "b.nhdr"})
    for (const bool compressed : {true, false}) {
      SCOPED_TRACE(std::string(name) + (compressed ? " compressed" : ""));
      write_labels(overlapping_organs(), folder / name, {.compressed = compressed});
      expect_same_map(read_labels(folder / name), overlapping_organs(), exact);
      write_labels(separate_organs(), folder / name, {.compressed = compressed});
      expect_same_map(read_labels(folder / name), separate_organs(), exact);
    }
}

TEST(LabelFiles, SegNrrdEscapesNames) {
  const TemporaryFolder folder;
  LabelMap map = separate_organs();
  map.segments.front().name = "a\\nb\\";
  write_labels(map, folder / "a.seg.nrrd");
  expect_same_map(read_labels(folder / "a.seg.nrrd"), map, exact);
}

TEST(LabelFiles, SegNrrdTellsExtents) {
  const TemporaryFolder folder;
  write_labels(overlapping_organs(), folder / "a.seg.nrrd");
  const std::string text = bytes_of(folder / "a.seg.nrrd");
  EXPECT_NE(text.find("Segment0_Extent:=1 2 1 2 1 3\n"), std::string::npos);
  EXPECT_NE(text.find("Segment1_Extent:=3 3 2 2 2 2\n"), std::string::npos);
}

TEST(LabelFiles, OldSegNrrdHasOneSegmentPerLayer) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.seg.nrrd",
              "NRRD0004\ntype: uchar\ndimension: 4\nspace: left-posterior-superior\nsizes: 2 1 1 2\n"
              "space directions: none (1,0,0) (0,1,0) (0,0,1)\nkinds: list domain domain domain\nencoding: raw\n"
              "Segment0_Name:=a\nSegment1_Name:=b:c\nSegment1_Color:=0 0.5 1\nSegment2_Name:=nowhere\n\n" +
                  std::string("\1\0\1\1", 4));
  const LabelMap map = read_labels(folder / "a.seg.nrrd");
  ASSERT_EQ(map.segments.size(), 2u);
  EXPECT_EQ(map.segments[1].name, "b:c");
  EXPECT_EQ(map.segments[1].layer, 1u);
  EXPECT_EQ(map.segments[1].color, (Color{0, 128, 255}));
  EXPECT_EQ(map.layers[0].voxels, (std::vector<std::uint16_t>{1, 1}));
  EXPECT_EQ(map.layers[1].voxels, (std::vector<std::uint16_t>{0, 1}));
  EXPECT_TRUE(has_warning(map.warnings, "segment left out: 'nowhere'"));
}

TEST(LabelFiles, NiftiKeepsNamesAndColours) {
  const TemporaryFolder folder;
  for (const char* name : {"a.nii", "a.nii.gz"}) {
    write_labels(separate_organs(), folder / name);
    expect_same_map(read_labels(folder / name), separate_organs(), single_precision_mm);
    EXPECT_EQ(read_volume(folder / name).voxels[oblique_grid().offset(3, 2, 2)], 2);
  }
}

TEST(LabelFiles, NiftiNamesOfTotalSegmentatorAreRead) {
  const TemporaryFolder folder;
  const std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?><CaretExtension><VolumeInformation Index=\"0\"><LabelTable>"
      "<Label Key=\"1\" Red=\"1\" Green=\"0.5\" Blue=\"0\" Alpha=\"1\"><![CDATA[spleen]]></Label>"
      "<Label Key=\"70000\">too large</Label></LabelTable></VolumeInformation></CaretExtension>";
  write_labels(separate_organs(), folder / "a.nii");
  std::string bytes = bytes_of(folder / "a.nii");
  const std::int32_t size = static_cast<std::int32_t>((8 + xml.size() + 15) / 16 * 16), code = 0;  // a comment
  float offset = 0;
  std::memcpy(&offset, bytes.data() + 108, 4);
  std::string extension(8, '\0');
  std::memcpy(extension.data(), &size, 4);
  std::memcpy(extension.data() + 4, &code, 4);
  extension += xml;
  extension.resize(static_cast<std::size_t>(size), '\0');
  bytes = bytes.substr(0, 352) + extension + bytes.substr(static_cast<std::size_t>(offset));
  offset = static_cast<float>(352 + size);
  std::memcpy(bytes.data() + 108, &offset, 4);
  write_bytes(folder / "a.nii", bytes);
  const LabelMap map = read_labels(folder / "a.nii");
  ASSERT_EQ(map.segments.size(), 1u);
  EXPECT_EQ(map.segments[0].name, "spleen");
  EXPECT_EQ(map.segments[0].color, (Color{255, 128, 0}));
  EXPECT_EQ(map.layers.front().voxels, separate_organs().layers.front().voxels);
}

TEST(LabelFiles, MetaImageKeepsLabelsWithoutNames) {
  const TemporaryFolder folder;
  for (const char* name : {"a.mha", "a.mhd"})
    for (const bool compressed : {true, false}) {
      write_labels(separate_organs(), folder / name, {.compressed = compressed});
      const LabelMap map = read_labels(folder / name);
      EXPECT_EQ(map.layers.front().voxels, separate_organs().layers.front().voxels);
      expect_same_grid(map.layers.front().grid, oblique_grid(), exact);
    }
  EXPECT_TRUE(std::filesystem::exists(folder / "a.zraw") && std::filesystem::exists(folder / "a.raw"));
}

TEST(LabelFiles, OverlapIsRefusedWhereItCannotBeKept) {
  const TemporaryFolder folder;
  for (const char* name : {"a.nii", "a.mha"}) {
    const std::string message = message_of([&] { write_labels(overlapping_organs(), folder / name); });
    EXPECT_NE(message.find("cannot overlap"), std::string::npos) << message;
    EXPECT_FALSE(std::filesystem::exists(folder / name));
  }
}

TEST(LabelFiles, NumbersThatDoNotFitKeepTheirNames) {
  Volume<float> volume(oblique_grid());
  volume.at(0, 0, 0) = 1;
  volume.at(1, 0, 0) = 7000000;
  volume.at(2, 0, 0) = -4;
  const TemporaryFolder folder;
  write_volume(stored_volume_of(volume), folder / "a.nrrd");
  const LabelMap map = read_labels(folder / "a.nrrd");
  ASSERT_EQ(map.segments.size(), 2u);
  for (const Segment& segment : map.segments) {
    const int i = segment.name == "-4" ? 2 : 1;
    EXPECT_EQ(segment.name, i == 2 ? "-4" : "7000000");
    EXPECT_EQ(map.layers.front().at(i, 0, 0), segment.value);
    EXPECT_GT(segment.value, 1);  // which is taken
  }
}

TEST(LabelFiles, GreyValuesAreNoLabels) {
  Volume<float> volume(oblique_grid());
  volume.at(1, 0, 0) = 0.5f;
  const TemporaryFolder folder;
  write_volume(stored_volume_of(volume), folder / "a.nrrd");
  EXPECT_NE(message_of([&] { read_labels(folder / "a.nrrd"); }).find("whole number"), std::string::npos);
}

TEST(LabelFilesErrors, DamageIsSurvived) {
  const TemporaryFolder folder;
  write_labels(overlapping_organs(), folder / "a.seg.nrrd", {.compressed = false});
  expect_labels_survive_damage(folder / "a.seg.nrrd");
  write_labels(separate_organs(), folder / "b.nii");
  expect_labels_survive_damage(folder / "b.nii");
  write_labels(separate_organs(), folder / "c.mha");
  expect_labels_survive_damage(folder / "c.mha");
}

TEST(LabelFilesErrors, AbsurdSizesAreRefusedBeforeAllocating) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.nrrd",
              "NRRD0004\ntype: uchar\ndimension: 4\nspace: left-posterior-superior\nsizes: 60000 60000 60000 2\n"
              "space directions: none (1,0,0) (0,1,0) (0,0,1)\nkinds: list domain domain domain\nencoding: raw\n\n123");
  EXPECT_NE(message_of([&] { read_labels(folder / "a.nrrd"); }).find("the header claims"), std::string::npos);
}

}  // namespace
}  // namespace isostack::testing
