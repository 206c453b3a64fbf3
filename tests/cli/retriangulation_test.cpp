// reconstruct --edge-length, --simplify, --triangles.
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace isostack {
namespace {

using testing_support::ProgramRun;

class Retriangulation : public testing_support::SampleTest {
 protected:
  ProgramRun reconstruct(const std::string& options) const { return reconstruct_sample(800, options); }
};

TEST_F(Retriangulation, IsReportedAndTheFileHoldsIt) {
  const ProgramRun full = reconstruct(""), even = reconstruct("--edge-length 4");
  ASSERT_EQ(full.exit_code, 0) << full.err;
  ASSERT_EQ(even.exit_code, 0) << even.err;
  EXPECT_TRUE(full.json()["surfaces"][0]["retriangulation"].is_null());
  const nlohmann::json surface = even.json()["surfaces"][0], report = surface["retriangulation"];
  EXPECT_EQ(report["triangles_before"], full.json()["surfaces"][0]["surface"]["triangles"]);
  EXPECT_EQ(report["triangles_after"], surface["surface"]["triangles"]);
  EXPECT_NEAR(report["edge_mm"]["median"].get<double>(), 4, 0.4);
  EXPECT_TRUE(surface["surface"]["watertight"]);
  EXPECT_EQ(surface["surface"]["genus"], full.json()["surfaces"][0]["surface"]["genus"]);
  const ProgramRun measured = isostack("measure " + path("organ.stl") + " --json");
  EXPECT_EQ(measured.json()["shape"]["triangles"], report["triangles_after"]);
}

TEST_F(Retriangulation, SimplifiedStaysWithinTheDistance) {
  const ProgramRun run = reconstruct("--simplify 0.3");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json report = run.json()["surfaces"][0]["retriangulation"];
  EXPECT_LE(report["largest_distance_mm"], 0.3);
  EXPECT_LT(report["triangles_after"].get<int>(), report["triangles_before"].get<int>() / 2);
  EXPECT_TRUE(run.json()["surfaces"][0]["surface"]["watertight"]);
  const ProgramRun few = reconstruct("--triangles 600");
  EXPECT_EQ(few.json()["surfaces"][0]["surface"]["triangles"], 600);
}

TEST_F(Retriangulation, WrongUsageAndTooManyTriangles) {
  EXPECT_EQ(reconstruct("--edge-length 0").exit_code, 2);
  EXPECT_EQ(reconstruct("--edge-length 2 --simplify 0.1").exit_code, 2);
  const ProgramRun run = reconstruct("--edge-length 0.001");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("triangles"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(path("organ.stl")));
}

}  // namespace
}  // namespace isostack
