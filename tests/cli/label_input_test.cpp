#include <filesystem>

#include "io/contours/contour_files.h"
#include "program.h"
#include "tests/io/seg_support.h"

namespace isostack::testing_support {
namespace {

class LabelInput : public ProgramTest {
 protected:
  /// 12 x 12 x 6 voxels of 1 mm: "liver" (1) left, "tumour" (2) within it in a layer of its own, value 5 without a
  /// name.
  std::string labels() const {
    std::string voxels;
    for (int k = 0; k < 6; ++k)
      for (int j = 0; j < 12; ++j)
        for (int i = 0; i < 12; ++i) {
          const bool inside = j > 1 && j < 10 && k > 0 && k < 5;
          voxels += static_cast<char>(inside && i > 0 && i < 7 ? 1 : inside && i > 7 && i < 11 ? 5 : 0);
          voxels += static_cast<char>(inside && j > 3 && j < 8 && i > 1 && i < 6 ? 2 : 0);
        }
    std::ofstream(path("labels.seg.nrrd"), std::ios::binary)
        << "NRRD0004\ntype: uchar\ndimension: 4\nspace: left-posterior-superior\nsizes: 2 12 12 6\n"
           "space directions: none (1,0,0) (0,1,0) (0,0,1)\nkinds: list domain domain domain\nencoding: raw\n"
           "Segment0_Name:=liver\nSegment0_LabelValue:=1\nSegment0_Layer:=0\nSegment0_Color:=1 0 0\n"
           "Segment1_Name:=tumour\nSegment1_LabelValue:=2\nSegment1_Layer:=1\n\n"
        << voxels;
    return path("labels.seg.nrrd");
  }

  /// Names of the organs that a run of segment tells.
  static std::vector<std::string> organs(const ProgramRun& run) {
    std::vector<std::string> names;
    const nlohmann::json result = run.json();
    for (const nlohmann::json& organ : result["organs"]) names.push_back(organ["name"]);
    return names;
  }
};

TEST_F(LabelInput, OrgansGetTheirNames) {
  const std::string input = labels(), out = " -o " + path("a.vtp") + " --json";
  using Names = std::vector<std::string>;
  EXPECT_EQ(organs(isostack("segment " + input + out)), (Names{"liver", "tumour", "5"}));
  EXPECT_EQ(organs(isostack("segment " + input + " --label tumour" + out)), Names{"tumour"});
  EXPECT_EQ(organs(isostack("segment " + input + " --label 1" + out)), Names{"liver"});
  const ProgramRun missing = isostack("segment " + input + " --label spleen" + out);
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_NE(missing.err.find("1 (liver), 2 (tumour), 5"), std::string::npos) << missing.err;
}

TEST_F(LabelInput, MeasuredByName) {
  const ProgramRun run = isostack("measure " + labels() + " --label tumour --json");
  EXPECT_EQ(run.json()["shape"]["voxels"], 4 * 4 * 4);
  EXPECT_EQ(isostack("measure " + labels() + " --json").json()["shape"]["voxels"], (6 + 3) * 8 * 4);
}

TEST_F(LabelInput, NamesAndOverlapGoThroughSegAndNrrd) {
  const std::string input = labels();
  ASSERT_EQ(isostack("segment " + input + " -o " + path("a.dcm") + " --as seg").exit_code, 0);
  ASSERT_EQ(isostack("segment " + path("a.dcm") + " -o " + path("b.seg.nrrd")).exit_code, 0);
  // Contours keep every voxel on its side, so the voxels are the same.
  for (const char* organ : {"liver", "tumour"}) {
    const auto voxels = [&](const std::string& file) {
      return isostack("measure " + file + " --label " + organ + " --json").json()["shape"]["voxels"];
    };
    EXPECT_EQ(voxels(path("a.dcm")), voxels(input)) << organ;
    EXPECT_EQ(voxels(path("b.seg.nrrd")), voxels(input)) << organ;
  }
  const ProgramRun flat = isostack("segment " + input + " -o " + path("c.nii.gz"));
  EXPECT_EQ(flat.exit_code, 0);
  EXPECT_NE(flat.err.find("overlap in 64 voxels"), std::string::npos) << flat.err;
}

TEST_F(LabelInput, UnevenSegmentationsBecomeContoursAtTheirPlaces) {
  // Squares of 5 x 5 pixels of 2 x 2 mm on planes at 0, 2, 5.3 and 6 mm.
  using testing::DicomBytes;
  const double heights_mm[] = {0, 2, 5.3, 6};
  std::string pixels;
  std::vector<DicomBytes> frames;
  for (const double z_mm : heights_mm) {
    for (int i = 0; i < 9 * 9; ++i)
      pixels += static_cast<char>(i % 9 > 1 && i % 9 < 7 && i / 9 > 1 && i / 9 < 7 ? 255 : 0);
    frames.push_back(testing::frame_item({1, z_mm, ""}));
  }
  pixels.resize((pixels.size() + 1) / 2 * 2);
  DicomBytes data = testing::segmentation(std::vector<testing::TestFrame>(4, {1, 0, ""}));
  DicomBytes measures, shared = testing::shared_item(1);
  measures.text(0x00280030, "DS", "2\\2");
  data.us(0x00280010, 9).us(0x00280011, 9).us(0x00280100, 8).us(0x00280101, 8).us(0x00280102, 7);
  data.text(0x00620001, "CS", "FRACTIONAL").us(0x0062000e, 255).set(0x7fe00010, "OB", pixels, 1);
  data.sequence(0x52009229, {shared.sequence(0x00289110, {measures})}).sequence(0x52009230, frames);
  std::ofstream(path("seg.dcm"), std::ios::binary) << data.file();

  for (const char* command : {"segment", "convert"}) {
    const ProgramRun run = isostack(std::string(command) + " " + path("seg.dcm") + " -o " + path("a.json"));
    ASSERT_EQ(run.exit_code, 0) << command << ": " << run.err;
    EXPECT_NE(run.err.find("uneven frames: "), std::string::npos) << run.err;
    const std::vector<ContourStack> organs = read_contours(path("a.json"));
    ASSERT_EQ(organs.size(), 1u) << command;
    EXPECT_EQ(organs[0].name, "one");
    ASSERT_EQ(organs[0].slices.size(), 4u) << command;
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(organs[0].slices[k].pose.origin_mm.z(), heights_mm[k], 1e-9);
      ASSERT_EQ(organs[0].slices[k].contours.size(), 1u);
      // Contours of labels round off corners, by less than a pixel of 4 mm2 each.
      EXPECT_NEAR(signed_area_mm2(organs[0].slices[k].contours[0]), 100, 4 * 4.0);
    }
  }
  const ProgramRun surface = isostack("reconstruct " + path("seg.dcm") + " -o " + path("a.stl") + " --json");
  EXPECT_EQ(surface.exit_code, 0) << surface.err;
  for (const char* output : {"a.nii.gz", "b.dcm"}) {
    const ProgramRun refused = isostack("convert " + path("seg.dcm") + " -o " + path(output));
    EXPECT_EQ(refused.exit_code, 3) << output;
    EXPECT_NE(refused.err.find("seg.dcm: its frames are not evenly spaced"), std::string::npos) << refused.err;
  }
  EXPECT_EQ(isostack("measure " + path("seg.dcm")).exit_code, 3);
  const ProgramRun info = isostack("info " + path("seg.dcm") + " --json");
  const nlohmann::json listed = info.json()["inputs"][0]["series"][0];
  EXPECT_EQ(listed["slices"], 4);
  EXPECT_EQ(listed["organs"][0]["number"], 1);
  EXPECT_EQ(listed["organs"][0]["frames"], 4);
  EXPECT_EQ(listed["organs"][0]["voxels"], 100);
}

TEST_F(LabelInput, ReconstructedLabelsKeepNames) {
  const ProgramRun run = isostack("reconstruct " + labels() + " --label liver -o " + path("a.nii.gz"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(isostack("measure " + path("a.nii.gz") + " --label liver").exit_code, 0);
  EXPECT_EQ(isostack("measure " + path("a.nii.gz") + " --label tumour").exit_code, 3);
}

}  // namespace
}  // namespace isostack::testing_support
