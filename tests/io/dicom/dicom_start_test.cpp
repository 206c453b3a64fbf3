#include "io/dicom/dicom_start.h"

#include "io/contours/contour_files.h"
#include "io/inspect.h"
#include "io/read_slices.h"
#include "tests/io/dicom_bytes.h"

namespace isostack::testing {
namespace {

const std::filesystem::path pydicom_files = "/usr/lib/python3/dist-packages/pydicom/data/test_files";

void expect_counting_pixels(const std::filesystem::path& path) {
  const SliceStack stack = read_slices(path);
  ASSERT_EQ(stack.slices.size(), 1u);
  EXPECT_EQ(stack.slices[0].pose.origin_mm, Eigen::Vector3d(-10, -20, 7));
  for (int i = 0; i < test_pixels; ++i) EXPECT_EQ(stack.slices[0].pixels.data()[i], i) << "pixel " << i;
}

TEST(DicomStart, DataSetsWithoutAnythingBeforeThemAreRead) {
  const TemporaryFolder folder;
  const DicomBytes data = picture_at(7, "1.2.3");
  const std::pair<DicomBytes::Encoding, const char*> encodings[] = {
      {{.explicit_vr = true, .big_endian = false}, "1.2.840.10008.1.2.1"},
      {{.explicit_vr = false, .big_endian = false}, "1.2.840.10008.1.2"},
      {{.explicit_vr = true, .big_endian = true}, "1.2.840.10008.1.2.2"}};
  for (const auto& [encoding, syntax] : encodings) {
    SCOPED_TRACE(syntax);
    write_bytes(folder / "x", data.encoded(encoding));
    ASSERT_TRUE(looks_like_dicom(folder / "x"));
    EXPECT_EQ(find_dicom_start(folder / "x")->guessed_syntax, syntax);
    expect_counting_pixels(folder / "x");
    // The same behind the magic bytes, without the meta header.
    write_bytes(folder / "x", std::string(128, '\0') + "DICM" + data.encoded(encoding));
    EXPECT_EQ(find_dicom_start(folder / "x")->offset, 132u);
    expect_counting_pixels(folder / "x");
  }
}

TEST(DicomStart, ThePreambleMayBeMissing) {
  const TemporaryFolder folder;
  for (const bool explicit_vr : {true, false}) {
    write_bytes(folder / "x", picture_at(7, "1.2.3").file({explicit_vr, false}).substr(132));
    ASSERT_TRUE(looks_like_dicom(folder / "x"));
    expect_counting_pixels(folder / "x");
  }
}

TEST(DicomStart, OneFolderMayHoldBothKinds) {
  const TemporaryFolder folder;
  write_bytes(folder / "a", picture_at(0, "1.2.3").file());
  write_bytes(folder / "b", picture_at(5, "1.2.4").encoded({.explicit_vr = false, .big_endian = false}));
  write_bytes(folder / "notes", "\x08 is a backspace");
  EXPECT_EQ(read_slices(folder.path()).slices.size(), 2u);
}

TEST(DicomStart, OtherFilesAreNotTakenForDicom) {
  const TemporaryFolder folder;
  const std::string element("\x08\x00\x05\x00", 4), length("\x02\x00\x00\x00", 4);
  const std::string others[] = {"",
                                "plain text that is long enough for a data set, but is none",
                                std::string(400, '\0'),
                                element + length + "ab",                            // one element only
                                element + length + "ab" + element + length + "ab",  // twice the same
                                element + std::string(4, '\xff') + std::string(100, '\0'),
                                std::string("\x08\x00", 2) + std::string(200, '\x40')};
  for (const std::string& bytes : others) {
    write_bytes(folder / "x", bytes);
    EXPECT_FALSE(looks_like_dicom(folder / "x")) << bytes;
  }
  EXPECT_FALSE(looks_like_dicom(folder / "nowhere"));
  EXPECT_FALSE(looks_like_dicom(folder.path()));
}

TEST(DicomStart, MagicBytesBeforeNonsenseAreDamage) {
  const TemporaryFolder folder;
  write_bytes(folder / "x.dcm", std::string(128, '\0') + "DICM" + std::string(100, 'x'));
  EXPECT_NE(message_of([&] { read_slices(folder / "x.dcm"); }).find("cut off or damaged"), std::string::npos);
}

TEST(DicomStart, StructureSetOfAPlanningSystemWithoutHeader) {
  const std::filesystem::path path = pydicom_files / "rtstruct.dcm";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "python3-pydicom is not installed";
  const ContourFile file = read_contour_file(path);
  ASSERT_EQ(file.organs.size(), 3u);
  EXPECT_EQ(file.organs[0].name, "patient");
  std::size_t contours = 0;
  for (const ContourStack& organ : file.organs)
    for (const ContourSlice& slice : organ.slices) contours += slice.contours.size();
  EXPECT_EQ(contours, 3u);
  EXPECT_EQ(inspect(path).front().kind, "DICOM RTSTRUCT");
}

}  // namespace
}  // namespace isostack::testing
