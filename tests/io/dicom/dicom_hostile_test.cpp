#include <random>

#include "io/dicom/dicom_header.h"
#include "io/inspect.h"
#include "io/read_slices.h"
#include "tests/io/dicom_bytes.h"

namespace isostack::testing {
namespace {

const std::filesystem::path pydicom_files = "/usr/lib/python3/dist-packages/pydicom/data/test_files";

/// Looks at it and reads it; both may refuse, neither may crash.
void try_to_read(const std::filesystem::path& path) {
  try {
    inspect(path);
  } catch (const Error& error) {
    EXPECT_STRNE(error.what(), "");
  }
  try {
    read_slices(path);
  } catch (const Error& error) {
    EXPECT_STRNE(error.what(), "");
  }
}

std::string two_frames() {
  DicomBytes data = picture_at(0, "1.2.3").text(0x00280008, "IS", "2");
  std::vector<DicomBytes> frames(2);
  for (int i = 0; i < 2; ++i)
    frames[static_cast<std::size_t>(i)].sequence(0x00209113,
                                                 {DicomBytes().text(0x00200032, "DS", decimals({0, 0, 5.0 * i}))});
  data.sequence(0x52009230, frames);
  return data.set(0x7fe00010, "OW", counting_pixels(2 * test_pixels), 2).file();
}

TEST(DicomHostile, EveryTruncationOfAMultiFrameFileIsRefused) {
  const TemporaryFolder folder;
  const std::string with_header = two_frames();
  const std::string without_header = with_header.substr(with_header.find(std::string("\x08\x00\x16\x00UI", 6)));
  for (const std::string& whole : {with_header, without_header})
    for (std::size_t length = 0; length < whole.size(); ++length) {
      write_bytes(folder / "x.dcm", whole.substr(0, length));
      EXPECT_THROW(read_slices(folder / "x.dcm"), Error) << length << " of " << whole.size() << " bytes";
    }
}

TEST(DicomHostile, FlippedBitsAreReadOrRefused) {
  const TemporaryFolder folder;
  std::mt19937 random(5);
  std::vector<std::string> files = {two_frames(), picture_at(0, "1.2.3").file({false, false}),
                                    picture_at(0, "1.2.3").file({true, true})};
  for (const char* name : {"MR_small_RLE.dcm", "MR_small_jp2klossless.dcm", "MR_small_jpeg_ls_lossless.dcm"})
    if (std::filesystem::exists(pydicom_files / name)) files.push_back(bytes_of(pydicom_files / name));
  for (const std::string& whole : files)
    for (int trial = 0; trial < 60; ++trial) {
      std::string bytes = whole;
      for (int flip = 0; flip < 1 + trial % 4; ++flip)
        bytes[132 + random() % (bytes.size() - 132)] ^= static_cast<char>(1u << random() % 8);
      write_bytes(folder / "x.dcm", bytes);
      try_to_read(folder / "x.dcm");
    }
}

TEST(DicomHostile, EveryFileOfPydicomIsReadOrRefused) {
  if (!std::filesystem::exists(pydicom_files)) GTEST_SKIP() << "python3-pydicom is not installed";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(pydicom_files))
    if (entry.is_regular_file()) {
      SCOPED_TRACE(entry.path());
      try_to_read(entry.path());
    }
}

TEST(DicomHostile, SizesThatTheFileCannotHold) {
  const TemporaryFolder folder;
  write_bytes(folder / "x.dcm", picture_at(0, "1.2.3").us(0x00280010, 65535).us(0x00280011, 65535).file());
  EXPECT_NE(message_of([&] { read_slices(folder / "x.dcm"); }).find("x.dcm: it claims 1 frame(s) of 65535 x 65535"),
            std::string::npos);
}

TEST(DicomHostile, DelimitersThatClaimMoreThanIsThere) {
  const TemporaryFolder folder;
  write_bytes(folder / "x.dcm", fragments_that_end_with(0));
  EXPECT_TRUE(read_dicom_header(folder / "x.dcm").is_compressed);
  write_bytes(folder / "x.dcm", fragments_that_end_with(0x53010000));  // GDCM makes room for these 1.4 GB
  EXPECT_NE(message_of([&] { read_dicom_header(folder / "x.dcm"); }).find("cut off or damaged"), std::string::npos);
}

TEST(DicomHostile, MissingTagsAreNamed) {
  const TemporaryFolder folder;
  const std::pair<std::uint32_t, std::string> needed[] = {
      {0x00280010, "no image"},      {0x00280011, "no image"},
      {0x7fe00010, "no image"},      {0x00280100, "pixels of 0 in 0 bits"},
      {0x00280030, "pixel spacing"}, {0x00200032, "position"},
      {0x00200037, "orientation"}};
  for (const auto& [tag, what] : needed) {
    write_bytes(folder / "x.dcm",
                picture_at(0, "1.2.3").without(tag).without(tag == 0x00280100 ? 0x00280101 : 0).file());
    const std::string message = message_of([&] { read_slices(folder / "x.dcm"); });
    EXPECT_NE(message.find(what), std::string::npos) << message;
  }
}

TEST(DicomHostile, PairsOfLettersThatAreNoVrAreDamage) {
  const TemporaryFolder folder;
  const std::string whole = picture_at(0, "1.2.3").file();
  for (const auto& [vr, wrong] : {std::pair{"UL", " L"}, {"UI", "S "}, {"CS", "S "}, {"DS", " D"}}) {
    std::string bytes = whole;
    bytes.replace(bytes.find(vr, 132), 2, wrong);
    write_bytes(folder / "x.dcm", bytes);
    EXPECT_NE(message_of([&] { read_dicom_header(folder / "x.dcm"); }).find("cut off or damaged"), std::string::npos)
        << vr;
  }
}

TEST(DicomHostile, ValuesThatAreNoNumbersAreMissing) {
  const TemporaryFolder folder;
  for (const char* position : {"", "a\\b\\c", "1\\2", "1e999\\0\\0", "nan\\0\\0"}) {
    write_bytes(folder / "x.dcm", picture_at(0, "1.2.3").text(0x00200032, "DS", position).file());
    EXPECT_NE(message_of([&] { read_slices(folder / "x.dcm"); }).find("the slice has no position"), std::string::npos)
        << position;
  }
  write_bytes(folder / "x.dcm",
              picture_at(0, "1.2.3").set(0x00200032, "FD", std::string(24, '\1'), 8).file());  // wrong VR
  EXPECT_NE(message_of([&] { read_slices(folder / "x.dcm"); }).find("the slice has no position"), std::string::npos);
  for (const char* spacing : {"0\\1", "-1\\1"}) {
    write_bytes(folder / "x.dcm", picture_at(0, "1.2.3").text(0x00280030, "DS", spacing).file());
    EXPECT_NE(message_of([&] { read_slices(folder / "x.dcm"); }).find("pixel spacing is not positive"),
              std::string::npos);
  }
}

TEST(DicomHostile, FoldersThatContainThemselves) {
  const TemporaryFolder folder;
  write_bytes(folder / "x.dcm", picture_at(0, "1.2.3").file());
  std::filesystem::create_directory(folder / "below");
  std::filesystem::create_directory_symlink(folder.path(), folder / "below/loop");
  EXPECT_EQ(read_slices(folder.path()).slices.size(), 1u);
}

TEST(DicomHostile, UnreadableFilesAreTold) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const TemporaryFolder folder;
  write_bytes(folder / "a.dcm", picture_at(0, "1.2.3").file());
  write_bytes(folder / "b.dcm", picture_at(5, "1.2.4").file());
  std::filesystem::permissions(folder / "b.dcm", std::filesystem::perms::none);
  EXPECT_TRUE(has_warning(read_slices(folder.path()).warnings,
                          "damaged files: left out, so a slice may be missing: b.dcm: the file cannot be opened"));
}

TEST(DicomHostile, FilesThatAreNotDicomAreRefusedAsSuch) {
  const TemporaryFolder folder;
  write_bytes(folder / "x.dcm", std::string(200, 'x'));
  EXPECT_NE(message_of([&] { read_slices(folder / "x.dcm"); }).find("x.dcm: it is not a DICOM file"),
            std::string::npos);
  EXPECT_TRUE(has_warning(inspect(folder / "x.dcm").front().warnings, "x.dcm: it is not a DICOM file"));
}

}  // namespace
}  // namespace isostack::testing
