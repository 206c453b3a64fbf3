// reconstruct: how it ends, how near it stays, how organs share a face.
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace isostack {
namespace {

using testing_support::ProgramRun;

class SurfaceOptions : public testing_support::SampleTest {
 protected:
  ProgramRun reconstruct(const std::string& options) const { return reconstruct_sample(2000, options); }
};

TEST_F(SurfaceOptions, OpenCapsLeaveARimAndMeasureSaysSo) {
  ASSERT_EQ(reconstruct("--caps open").exit_code, 0);
  const ProgramRun measured = isostack("measure " + path("organ.stl") + " --json");
  ASSERT_EQ(measured.exit_code, 0) << measured.err;
  EXPECT_FALSE(measured.json()["shape"]["watertight"]);
  EXPECT_GT(measured.json()["shape"]["boundary_edges"], 10);
  const ProgramRun flat = reconstruct("--caps flat");
  ASSERT_EQ(flat.exit_code, 0) << flat.err;
  EXPECT_TRUE(flat.json()["surfaces"][0]["surface"]["watertight"]);
}

TEST_F(SurfaceOptions, LabelsNeedAClosedSurface) {
  EXPECT_EQ(reconstruct("--caps open -o " + path("labels.nii.gz")).exit_code, 2);
}

TEST_F(SurfaceOptions, ToleranceIsKeptAndReported) {
  const ProgramRun run = reconstruct("--tolerance 1.5");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json surface = run.json()["surfaces"][0];
  EXPECT_LE(surface["contour_residual_mm"]["largest"], 1.5);
  EXPECT_LE(surface["contour_residual_mm"]["mean"], surface["contour_residual_mm"]["p95"]);
  EXPECT_GT(surface["smoothing"], 0);
}

TEST_F(SurfaceOptions, ToleranceOutOfReachSaysWhatIs) {
  const ProgramRun run = reconstruct("--tolerance 0.001");
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_NE(run.err.find("mm from the contours"), std::string::npos) << run.err;
}

TEST_F(SurfaceOptions, ContradictingOptionsAreWrongUsage) {
  EXPECT_EQ(reconstruct("--tolerance 1 --interpolate").exit_code, 2);
  EXPECT_EQ(reconstruct("--tolerance 1 --smoothing 3").exit_code, 2);
  EXPECT_EQ(reconstruct("--thin 1 --preset turk-obrien").exit_code, 2);
  EXPECT_EQ(reconstruct("--caps pointed").exit_code, 2);
}

TEST_F(SurfaceOptions, ThinningUsesFewerConstraints) {
  const ProgramRun all = reconstruct("--interpolate"), thinned = reconstruct("--thin 1.5");
  ASSERT_EQ(all.exit_code, 0) << all.err;
  ASSERT_EQ(thinned.exit_code, 0) << thinned.err;
  EXPECT_LT(thinned.json()["surfaces"][0]["constraints"], all.json()["surfaces"][0]["constraints"]);
  EXPECT_LE(thinned.json()["surfaces"][0]["contour_residual_mm"]["largest"], 1.5);
}

}  // namespace
}  // namespace isostack
