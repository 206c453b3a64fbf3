#include "io/dicom/dicom_phases.h"

#include "io/inspect.h"
#include "io/read_slices.h"
#include "tests/io/dicom_bytes.h"

namespace isostack::testing {
namespace {

// Plain sums of strings make GCC 12 warn of overlaps that are not there.
std::string file_name(int number) { return std::string("f").append(std::to_string(number)).append(".dcm"); }
std::string uid(int number) { return std::string("1.2.3.").append(std::to_string(number)); }

/// Writes `count` files of two pictures each at 0, 10, 20 ... mm; `mark` says what tells the two apart.
template <class Mark>
void write_pairs(const TemporaryFolder& folder, int count, Mark mark) {
  for (int place = 0; place < count; ++place)
    for (int time = 0; time < 2; ++time) {
      const int number = 2 * place + time;
      DicomBytes data = picture_at(10 * place, uid(number));
      data.set(0x7fe00010, "OW", counting_pixels(test_pixels, 100 * time + 1000 * place), 2);
      mark(data, place, time);
      write_bytes(folder / file_name(number), data.file());
    }
}

/// Slices of phase `time` + 1 hold the pixels of that time.
void expect_phases(const TemporaryFolder& folder, const std::string& told_apart_by) {
  EXPECT_EQ(inspect(folder.path()).front().phases_by, told_apart_by);
  for (int time = 0; time < 2; ++time) {
    const SliceStack stack = read_slices(folder.path(), {.phase = time + 1});
    ASSERT_EQ(stack.slices.size(), 3u);
    for (int place = 0; place < 3; ++place) {
      const Slice& slice = stack.slices[static_cast<std::size_t>(place)];
      EXPECT_EQ(slice.pose.origin_mm.z(), 10 * place);
      EXPECT_EQ(slice.pixels(0, 0), 100 * time + 1000 * place);
    }
  }
}

TEST(DicomPhases, TemporalPositionComesFirst) {
  const TemporaryFolder folder;
  write_pairs(folder, 3, [](DicomBytes& data, int, int time) {
    data.text(0x00200100, "IS", std::to_string(5 + time)).text(0x00181060, "DS", std::to_string(50 - time));
  });
  expect_phases(folder, "TemporalPosition");
}

TEST(DicomPhases, TriggerTimesNeedNotAgreeBetweenPlaces) {
  const TemporaryFolder folder;
  write_pairs(folder, 3, [](DicomBytes& data, int place, int time) {
    data.text(0x00181060, "DS", std::to_string(20 * time + 30 * place)).text(0x00200013, "IS", std::to_string(-time));
  });
  expect_phases(folder, "TriggerTime");
}

TEST(DicomPhases, AcquisitionTimeRunsAcrossMidnight) {
  const TemporaryFolder folder;
  write_pairs(folder, 3, [](DicomBytes& data, int, int time) {
    data.text(0x00080022, "DA", time == 0 ? "20250131" : "20250201");
    data.text(0x00080032, "TM", time == 0 ? "235959.5" : "000001");
  });
  expect_phases(folder, "AcquisitionTime");
}

TEST(DicomPhases, InstanceNumberIsBetterThanNothing) {
  const TemporaryFolder folder;
  write_pairs(folder, 3, [](DicomBytes& data, int place, int time) {
    data.text(0x00200013, "IS", std::to_string(2 * place + time)).text(0x00080032, "TM", "120000");
  });
  expect_phases(folder, "InstanceNumber");
}

TEST(DicomPhases, RepeatedPositionsNeedAChoice) {
  const TemporaryFolder folder;
  write_pairs(folder, 3, [](DicomBytes&, int, int) {});
  const std::string message = message_of([&] { read_slices(folder.path()); });
  EXPECT_NE(message.find("f1.dcm: the slice lies at the same position as f0.dcm: 6 slices lie at 3 place(s)"),
            std::string::npos)
      << message;
  EXPECT_NE(message.find("--phase 1 to 2"), std::string::npos);
  EXPECT_NE(message_of([&] { read_slices(folder.path(), {.phase = 3}); }).find("there is no phase 3"),
            std::string::npos);
  EXPECT_TRUE(has_warning(inspect(folder.path()).front().warnings, "repeated positions: up to 2 slices"));
}

TEST(DicomPhases, IncompletePhasesAreTold) {
  const TemporaryFolder folder;
  write_pairs(folder, 3, [](DicomBytes& data, int place, int time) {
    data.text(0x00200013, "IS", std::to_string(2 * place + time));
  });
  std::filesystem::remove(folder / "f3.dcm");
  const SliceStack second = read_slices(folder.path(), {.phase = 2});
  EXPECT_EQ(second.slices.size(), 2u);
  EXPECT_TRUE(has_warning(second.warnings, "incomplete phases: 1 of 3 places have fewer than 2 slices"));
}

TEST(DicomPhases, CopiesOfOneFileCountOnce) {
  const TemporaryFolder folder;
  for (int i = 0; i < 3; ++i) write_bytes(folder / file_name(i), picture_at(5 * i, uid(i)).file());
  std::filesystem::copy_file(folder / "f1.dcm", folder / "f1 copy.dcm");
  const SliceStack stack = read_slices(folder.path());
  EXPECT_EQ(stack.slices.size(), 3u);
  EXPECT_TRUE(has_warning(stack.warnings, "duplicate files: "));
}

TEST(DicomOrder, LocalizersOfCtAreLeftOut) {
  const TemporaryFolder folder;
  for (int i = 0; i < 3; ++i)
    write_bytes(folder / file_name(i), picture_at(5 * i, uid(i)).text(0x00080060, "CS", "CT").file());
  DicomBytes scout = picture_at(0, "1.2.3.9").text(0x00080060, "CS", "CT");
  scout.text(0x00080008, "CS", "ORIGINAL\\PRIMARY\\LOCALIZER").text(0x00200037, "DS", "1\\0\\0\\0\\0\\-1");
  write_bytes(folder / "scout.dcm", scout.us(0x00280010, 2).set(0x7fe00010, "OW", counting_pixels(10), 2).file());
  const SliceStack stack = read_slices(folder.path());
  EXPECT_EQ(stack.slices.size(), 3u);
  EXPECT_TRUE(has_warning(stack.warnings, "localizers: scout.dcm left out"));
  EXPECT_NE(message_of([&] { read_slices(folder / "scout.dcm"); }).find("scout.dcm: it is a localizer"),
            std::string::npos);
}

TEST(DicomOrder, ASceneLeavesOutWhatHasNoPlaceASeriesDoesNot) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.dcm", picture_at(0, "1.2.3.1").file());
  write_bytes(folder / "b.dcm", picture_without_place("1.2.3.2").text(0x0020000e, "UI", "1.9").file());
  const SliceStack scene = read_slices(folder.path(), {.series = "all"});
  EXPECT_EQ(scene.slices.size(), 1u);
  EXPECT_TRUE(has_warning(scene.warnings, "unusable pictures: b.dcm left out, b.dcm: the slice has no position"));
  EXPECT_NE(message_of([&] { read_slices(folder.path(), {.series = "2"}); }).find("b.dcm: the slice has no position"),
            std::string::npos);
}

TEST(DicomOrder, DirectionsOfOneSeriesMayDifferInSize) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.dcm", picture_at(0, "1.2.3.1").file());
  DicomBytes crossing = picture_at(0, "1.2.3.2").text(0x00200037, "DS", "1\\0\\0\\0\\0\\-1");
  write_bytes(folder / "b.dcm", crossing.us(0x00280010, 2).set(0x7fe00010, "OW", counting_pixels(10), 2).file());
  const SeriesSummary summary = inspect(folder.path()).front();
  ASSERT_EQ(summary.orientations.size(), 2u);
  EXPECT_EQ(summary.orientations[0].letters, "LPS");
  EXPECT_EQ(summary.orientations[1].letters, "LIP");
  EXPECT_EQ(summary.orientations[1].slice_count, 1u);
  EXPECT_EQ(read_slices(folder.path()).slices[1].pixels.rows(), 2);
}

TEST(DicomOrder, WarningsNameWhatIsDoubtful) {
  const TemporaryFolder folder;
  for (int i = 0; i < 3; ++i) {
    DicomBytes data = picture_at(5 * i, uid(i));
    data.text(0x00180088, "DS", "2.5").text(0x00180050, "DS", "8").text(0x00282110, "CS", "01");
    data.text(0x00200052, "UI", i == 2 ? "1.7" : "1.6");
    write_bytes(folder / file_name(i), data.file());
  }
  const SeriesSummary summary = inspect(folder.path()).front();
  EXPECT_EQ(summary.slice_thickness_mm, 8);
  EXPECT_NEAR(summary.gaps->median_mm, 5, 1e-12);  // not what SpacingBetweenSlices says
  EXPECT_TRUE(has_warning(summary.warnings, "differing spacing: the header says 2.50 mm"));
  EXPECT_TRUE(has_warning(summary.warnings, "overlapping slices: they are 8.00 mm thick and 5.00 mm apart"));
  EXPECT_TRUE(has_warning(summary.warnings, "lossy compression: the grey values of 3 slices"));
  EXPECT_TRUE(has_warning(summary.warnings, "differing frames of reference: f0.dcm and f2.dcm"));
}

}  // namespace
}  // namespace isostack::testing
