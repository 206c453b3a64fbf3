#include "io/dicom/dicom_frames.h"

#include "io/inspect.h"
#include "io/read_slices.h"
#include "tests/io/dicom_bytes.h"

namespace isostack::testing {
namespace {

/// What an enhanced image says about one frame at this height, with its own rescale.
DicomBytes frame_at(double z_mm, double intercept, int temporal_position = 1) {
  DicomBytes frame;
  frame.sequence(0x00209113, {DicomBytes().text(0x00200032, "DS", decimals({-10, -20, z_mm}))});
  frame.sequence(0x00289145,
                 {DicomBytes().text(0x00281052, "DS", decimals({intercept})).text(0x00281053, "DS", "0.5")});
  frame.sequence(0x00209111, {DicomBytes().ul(0x00209128, static_cast<std::uint64_t>(temporal_position))});
  return frame;
}

/// An enhanced MR image of these frames; orientation and spacing are shared.
DicomBytes enhanced(const std::vector<DicomBytes>& frames) {
  DicomBytes data = picture_without_place("1.2.3.4.5");
  data.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.4.1");
  data.text(0x00280008, "IS", std::to_string(frames.size()));
  DicomBytes shared;
  shared.sequence(0x00209116, {DicomBytes().text(0x00200037, "DS", "0\\1\\0\\0\\0\\-1")});
  shared.sequence(0x00289110, {DicomBytes().text(0x00280030, "DS", "3\\2").text(0x00180050, "DS", "4")});
  data.sequence(0x52009229, {shared}).sequence(0x52009230, frames);
  return data.set(0x7fe00010, "OW", counting_pixels(test_pixels * static_cast<int>(frames.size())), 2);
}

/// Frames in no order along the normal of sagittal planes, -x.
std::vector<DicomBytes> frames_out_of_order() {
  std::vector<DicomBytes> frames = {frame_at(0, 100), frame_at(0, 200), frame_at(0, 300)};
  const double x_mm[] = {0, 8, 4};
  for (std::size_t i = 0; i < 3; ++i)
    frames[i].sequence(0x00209113, {DicomBytes().text(0x00200032, "DS", decimals({x_mm[i], -20, 7}))});
  return frames;
}

TEST(DicomFrames, EachFrameIsASliceWithItsOwnPlaceAndRescale) {
  for (const auto encoding : {DicomBytes::Encoding{true, false}, {false, false}, {true, true}}) {
    const TemporaryFolder folder;
    write_bytes(folder / "x.dcm", enhanced(frames_out_of_order()).file(encoding));
    const SliceStack stack = read_slices(folder / "x.dcm");
    ASSERT_EQ(stack.slices.size(), 3u);
    const double x_mm[] = {8, 4, 0};
    const int frame[] = {1, 2, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      const Slice& slice = stack.slices[i];
      EXPECT_EQ(slice.name, std::string("x.dcm frame ").append(std::to_string(frame[i] + 1)));
      EXPECT_EQ(slice.pose.origin_mm, Eigen::Vector3d(x_mm[i], -20, 7));
      EXPECT_EQ(slice.pose.x_axis, Eigen::Vector3d(0, 1, 0));
      EXPECT_EQ(slice.pose.y_axis, Eigen::Vector3d(0, 0, -1));
      EXPECT_EQ(slice.pose.spacing_mm, Eigen::Vector2d(2, 3));
      for (int pixel = 0; pixel < test_pixels; ++pixel)  // exact in binary
        EXPECT_EQ(slice.pixels.data()[pixel], 0.5f * (test_pixels * frame[i] + pixel) + 100 * (frame[i] + 1));
    }
  }
}

TEST(DicomFrames, TemporalPositionsArePhases) {
  const TemporaryFolder folder;
  // Axial planes, for frame_at() differs in z only.
  DicomBytes axial = enhanced({frame_at(0, 12, 2), frame_at(0, 11, 1), frame_at(5, 21, 1), frame_at(5, 22, 2)});
  DicomBytes shared;
  shared.sequence(0x00209116, {DicomBytes().text(0x00200037, "DS", "1\\0\\0\\0\\1\\0")});
  shared.sequence(0x00289110, {DicomBytes().text(0x00280030, "DS", "3\\2")});
  write_bytes(folder / "x.dcm", axial.sequence(0x52009229, {shared}).file());
  const SeriesSummary summary = inspect(folder / "x.dcm").front();
  EXPECT_EQ(summary.phase_count, 2);
  EXPECT_EQ(summary.phases_by, "TemporalPosition");
  EXPECT_EQ(summary.slice_count, 2u);
  for (const int phase : {1, 2}) {
    const SliceStack stack = read_slices(folder / "x.dcm", {.phase = phase});
    ASSERT_EQ(stack.slices.size(), 2u);
    EXPECT_EQ(stack.slices[0].name, phase == 1 ? "x.dcm frame 2" : "x.dcm frame 1");
    EXPECT_EQ(stack.slices[1].name, phase == 1 ? "x.dcm frame 3" : "x.dcm frame 4");
  }
}

TEST(DicomFrames, PlainFramesWithoutPlacesAreRefused) {
  const TemporaryFolder folder;
  DicomBytes data = picture_at(0, "1.2.3.4.5").text(0x00280008, "IS", "3");
  write_bytes(folder / "x.dcm", data.set(0x7fe00010, "OW", counting_pixels(3 * test_pixels), 2).file());
  EXPECT_NE(message_of([&] {
              read_slices(folder.path());
            }).find("x.dcm: the file holds 3 frames and does not say where they lie"),
            std::string::npos);
  EXPECT_TRUE(has_warning(inspect(folder.path()).front().warnings, "unusable: x.dcm: the file holds 3 frames"));
}

TEST(DicomFrames, FrameCountsThatTheFileCannotHoldAreRefusedBeforeAllocating) {
  const TemporaryFolder folder;
  for (const char* claimed : {"1000000000", "99999999999", "4"}) {
    write_bytes(folder / "x.dcm", enhanced(frames_out_of_order()).text(0x00280008, "IS", claimed).file());
    const std::string message = message_of([&] { read_slices(folder / "x.dcm"); });
    EXPECT_NE(message.find("x.dcm: it claims "), std::string::npos) << message;
  }
  write_bytes(folder / "x.dcm", enhanced(frames_out_of_order()).text(0x00280008, "IS", "2").file());
  EXPECT_NE(message_of([&] { read_slices(folder / "x.dcm"); }).find("claims 2 frames but describes 3"),
            std::string::npos);
}

TEST(DicomFrames, DosePlanesLieAtTheirOffsets) {
  const std::filesystem::path path = "/usr/lib/python3/dist-packages/pydicom/data/test_files/rtdose.dcm";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "python3-pydicom is not installed";
  const SliceStack dose = read_slices(path);
  ASSERT_EQ(dose.slices.size(), 15u);
  const std::vector<double> heights_mm = positions_along_normal_mm(dose.slices);
  for (std::size_t i = 1; i < 15; ++i) EXPECT_NEAR(heights_mm[i] - heights_mm[i - 1], 5, 1e-9);
  const SliceStack big_endian = read_slices(path.parent_path() / "rtdose_expb.dcm");
  const SliceStack run_length = read_slices(path.parent_path() / "rtdose_rle.dcm");
  for (std::size_t i = 0; i < 15; ++i) {
    EXPECT_TRUE((dose.slices[i].pixels == big_endian.slices[i].pixels).all());
    EXPECT_TRUE((dose.slices[i].pixels == run_length.slices[i].pixels).all());
  }
}

}  // namespace
}  // namespace isostack::testing
