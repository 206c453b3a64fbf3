// isostack measure: shapes against shapes, and slices left out.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/cli/program.h"

namespace isostack {
namespace {

using testing_support::ProgramRun;

class Measure : public testing_support::SampleTest {
 protected:
  /// A box from 0 to (x, 10, 10) mm.
  std::string box(const std::string& name, double x) const {
    std::ofstream file(path(name));
    for (int c = 0; c < 8; ++c)
      file << "v " << (c & 1 ? x : 0) << ' ' << (c & 2 ? 10 : 0) << ' ' << (c & 4 ? 10 : 0) << '\n';
    for (const char* face :
         {"1 5 7", "1 7 3", "2 4 8", "2 8 6", "1 2 6", "1 6 5", "3 7 8", "3 8 4", "1 3 4", "1 4 2", "5 6 8", "5 8 7"})
      file << "f " << face << '\n';
    return path(name);
  }
};

TEST_F(Measure, BoxesDifferByOneFace) {
  const ProgramRun run = isostack("measure " + box("a.obj", 12) + " --against " + box("b.obj", 10) + " --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json comparison = run.json()["comparison"];
  EXPECT_NEAR(comparison["volume_difference_mm3"], 200, 1e-6);
  EXPECT_NEAR(comparison["volume_difference_percent"], 20, 1e-6);
  EXPECT_NEAR(comparison["area_difference_mm2"], 80, 1e-6);
  EXPECT_NEAR(comparison["largest_distance_mm"], 2, 1e-3);  // the whole face; samples reach it everywhere
  EXPECT_NEAR(comparison["diagonal_mm"], std::sqrt(300.0), 1e-6);
  EXPECT_NEAR(comparison["largest_distance_of_diagonal"], 2 / std::sqrt(300.0), 1e-4);
  EXPECT_NEAR(comparison["dice"], 2.0 * 1000 / 2200, 0.01);  // on 200 voxels along the diagonal
  for (const char* shape : {"shape", "against"}) {
    EXPECT_EQ(run.json()[shape]["genus"], 0);
    EXPECT_EQ(run.json()[shape]["components"], 1);
  }
}

TEST_F(Measure, LabelsAreComparedByTheirVoxelsSurface) {
  std::ofstream(path("labels.mhd")) << "ObjectType = Image\nNDims = 3\nBinaryData = True\nOffset = -1.5 -1.5 -1.5\n"
                                       "ElementSpacing = 1 1 1\nDimSize = 14 14 14\nElementType = MET_UCHAR\n"
                                       "ElementDataFile = labels.raw\n";
  std::string voxels(14 * 14 * 14, '\0');  // voxels 2 to 11: their faces are the box from 0 to 10 mm
  for (int k = 2; k < 12; ++k)
    for (int j = 2; j < 12; ++j)
      for (int i = 2; i < 12; ++i) voxels[static_cast<std::size_t>((k * 14 + j) * 14 + i)] = 3;
  std::ofstream(path("labels.raw"), std::ios::binary) << voxels;
  const ProgramRun run =
      isostack("measure " + path("labels.mhd") + " --label 3 --against " + box("b.obj", 10) + " --samples 2000 --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NEAR(run.json()["shape"]["volume_mm3"], 1000, 1e-6);
  EXPECT_EQ(run.json()["shape"]["genus"], 0);
  const nlohmann::json comparison = run.json()["comparison"];
  EXPECT_EQ(comparison["dice"], 1);
  EXPECT_LT(comparison["largest_distance_mm"], 1e-6);
  EXPECT_FALSE(comparison.contains("area_difference_mm2"));
  EXPECT_EQ(isostack("measure " + path("labels.mhd") + " --label 4").exit_code, 3);
}

TEST_F(Measure, LeavingSlicesOutComparesThreeMethods) {
  const ProgramRun run =
      isostack("measure " + path("sample/series") +
               " --level 25 --largest --leave-out 2,3 --max-constraints 1500 --plot " + path("plot.svg") + " --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json studies = run.json()["leave_out"];
  ASSERT_EQ(studies.size(), 2u);
  EXPECT_EQ(studies[0]["every"], 2);
  EXPECT_EQ(studies[0]["kept"], 15);
  EXPECT_EQ(studies[0]["dropped"], 14);  // of 15; the last lies beyond the kept ones
  ASSERT_EQ(studies[0]["methods"].size(), 3u);
  for (const nlohmann::json& method : studies[0]["methods"]) EXPECT_GT(method["dice"], 0.9) << method;
  EXPECT_NE(testing_support::file_text(path("plot.svg")).find("</svg>"), std::string::npos);
}

TEST_F(Measure, RefusesWhatMakesNoSense) {
  EXPECT_EQ(isostack("measure " + box("a.obj", 1) + " " + box("b.obj", 2)).exit_code, 2);
  EXPECT_EQ(isostack("measure " + path("sample/series") + " --level 25 --leave-out 1").exit_code, 2);
  EXPECT_EQ(isostack("measure " + path("sample/series") + " --level 25 --leave-out 2 --plot plot.png").exit_code, 3);
  EXPECT_EQ(isostack("measure " + path("sample/series") + " --level 25 --leave-out 500").exit_code, 3);
}

}  // namespace
}  // namespace isostack
