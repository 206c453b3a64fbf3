// `isostack morph --method level-set`: what it tells, and what it refuses.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/cli/program.h"

namespace isostack {
namespace {

using testing_support::ProgramRun;

class MorphLevelSet : public testing_support::ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    ASSERT_EQ(run_command(ISOSTACK_MAKE_SHAPES " " + path("shapes")).exit_code, 0);
  }
  std::string shape(const std::string& name) const { return path("shapes/" + name) + " "; }
  ProgramRun morph(const std::string& arguments) const {
    return isostack("morph --method level-set --frames 3 --json -o " + path("frames.json") + " " + arguments);
  }
};

TEST_F(MorphLevelSet, TellsHowTheEvolutionWentAndEndsAsTheTarget) {
  const ProgramRun run = morph(shape("x.png") + shape("o.png"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json course = run.json()["courses"][0];
  EXPECT_TRUE(course["arrived"]);
  EXPECT_LT(course["shared_fraction"][0], 0.5);
  EXPECT_GT(course["shared_fraction"][1], 0.99);
  EXPECT_LE(course["largest_mm"][1], 0.5);
  EXPECT_EQ(run.json()["frames"][2]["holes"], 1);
}

TEST_F(MorphLevelSet, SaysWhichPartsStayMissing) {
  const auto square = [&](const std::string& name, const std::string& contours) {
    std::ofstream(path(name))
        << R"({"format": "isostack-contours", "version": 1, "organs": [{"name": "square", "slices": [
      {"name": "slice", "pose": {"origin_mm": [0,0,0], "x_axis": [1,0,0], "y_axis": [0,1,0], "spacing_mm": [1,1]},
       "size_pixels": [0,0], "contours": [)" +
               contours + "]}]}]}";
  };
  const std::string left = R"({"points_mm": [[0,0],[10,0],[10,10],[0,10]]})";
  const std::string right = R"({"points_mm": [[30,0],[40,0],[40,10],[30,10]]})";
  square("one.json", left);
  square("two.json", left + "," + right);
  square("other.json", right);
  const ProgramRun run = morph(path("one.json") + " " + path("two.json"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json part = run.json()["unshared_parts"][0];
  EXPECT_NEAR(part["content"], 100, 21);  // pixels of a square of 10 by 10: a row more or less
  EXPECT_NEAR(part["place_mm"][0], 35, 1);
  EXPECT_NE(run.err.find("two.json"), std::string::npos) << run.err;
  EXPECT_EQ(run.json()["frames"][2]["components"], 1);
  const ProgramRun seeded = morph("--missing-parts seed " + path("one.json") + " " + path("two.json"));
  EXPECT_EQ(seeded.json()["frames"][2]["components"], 2);
  EXPECT_EQ(morph(path("one.json") + " " + path("other.json")).exit_code, 3);
}

/// Mesh, constructive solid, slices of contours (what a scan becomes), mesh: one animation.
TEST_F(MorphLevelSet, BodiesOfEveryOriginTakePartInOneSequence) {
  std::ofstream(path("solid.json")) << R"({"format": "isostack-solid", "version": 1, "solid": {"difference": [
    {"superellipsoid": {"radii_mm": [25, 25, 15], "exponents": [0.5, 0.5]}},
    {"superellipsoid": {"radii_mm": [9, 9, 40]}}]}})";
  std::ofstream slices(path("slices.json"));
  slices << R"({"format": "isostack-contours", "version": 1, "organs": [{"name": "ball", "slices": [)";
  for (int k = -4; k <= 4; ++k) {  // a ball of 20 mm
    slices << (k > -4 ? "," : "") << R"({"name": "slice )" << k + 4 << R"(", "pose": {"origin_mm": [0,0,)" << 4 * k
           << R"(], "x_axis": [1,0,0], "y_axis": [0,1,0], "spacing_mm": [1,1]}, "size_pixels": [0,0],
              "contours": [{"points_mm": [)";
    for (int i = 0; i < 60; ++i)
      slices << (i > 0 ? "," : "") << "[" << std::sqrt(400.0 - 16 * k * k) * std::cos(i * M_PI / 30) << ","
             << std::sqrt(400.0 - 16 * k * k) * std::sin(i * M_PI / 30) << "]";
    slices << "]}]}";
  }
  slices << "]}]}";
  slices.close();
  const ProgramRun run =
      isostack("morph --method level-set --frames 4 --resolution 2 --json -o " + path("bodies") + " " +
               shape("torus.ply") + path("solid.json") + " " + path("slices.json") + " " + shape("torus.ply"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json frames = run.json()["frames"];
  const std::vector<int> genus = {1, 1, 0, 1};
  for (std::size_t i = 0; i < genus.size(); ++i) {
    EXPECT_EQ(frames[i]["genus"], genus[i]) << i;
    EXPECT_EQ(frames[i]["components"], 1) << i;
  }
  EXPECT_NEAR(frames[2]["volume_mm3"], 33510, 670);  // 4/3 π 20³ within 2 %: voxels of 2 mm
}

TEST_F(MorphLevelSet, RefusesWhatIsNotItsOwn) {
  EXPECT_EQ(morph(shape("x.png") + shape("o.png") + "--path \"1,0;0,1\"").exit_code, 2);
  EXPECT_EQ(morph(shape("x.png") + shape("o.png") + "--between cubic").exit_code, 2);
  EXPECT_EQ(morph(shape("x.png") + shape("o.png") + "--transform warp").exit_code, 3);
  EXPECT_EQ(isostack("morph --pace rms -o " + path("f.json") + " " + shape("x.png") + shape("o.png")).exit_code, 2);
}

}  // namespace
}  // namespace isostack
