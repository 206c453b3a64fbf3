#include <filesystem>

#include "program.h"

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

TEST_F(LabelInput, ReconstructedLabelsKeepNames) {
  const ProgramRun run = isostack("reconstruct " + labels() + " --label liver -o " + path("a.nii.gz"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(isostack("measure " + path("a.nii.gz") + " --label liver").exit_code, 0);
  EXPECT_EQ(isostack("measure " + path("a.nii.gz") + " --label tumour").exit_code, 3);
}

}  // namespace
}  // namespace isostack::testing_support
