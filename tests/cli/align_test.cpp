// Crossing slices that contradict each other, through the real program.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "tests/cli/program.h"

namespace isostack {
namespace {

using testing_support::ProgramRun;

class AlignCommand : public testing_support::ProgramTest {
 protected:
  using Json = nlohmann::json;

  /// A cut of a sphere of radius 30 mm: across z, or across y (`upright`), moved by `shift_mm` along x.
  static Json sphere_cut(bool upright, double height_mm, double shift_mm) {
    const double radius = std::sqrt(900 - height_mm * height_mm);
    Json points = Json::array();
    for (int i = 0; i < 120; ++i) {
      const double angle = 2 * std::numbers::pi * i / 120;
      points.push_back({radius * std::cos(angle) + shift_mm, radius * std::sin(angle)});
    }
    const Json origin = upright ? Json{0, height_mm, 0} : Json{0, 0, height_mm};
    const Json y_axis = upright ? Json{0, 0, 1} : Json{0, 1, 0};
    return {{"name", std::string(upright ? "upright " : "flat ") + std::to_string(static_cast<int>(height_mm))},
            {"pose", {{"origin_mm", origin}, {"x_axis", {1, 0, 0}}, {"y_axis", y_axis}, {"spacing_mm", {1, 1}}}},
            {"contours", Json::array({{{"points_mm", points}}})}};
  }

  std::string write(const Json& slices) const {
    const Json document = {{"format", "isostack-contours"},
                           {"version", 1},
                           {"organs", Json::array({{{"name", "ball"}, {"slices", slices}}})}};
    std::ofstream(path("in.json")) << document;
    return path("in.json");
  }
};

TEST_F(AlignCommand, AMovedSliceIsReportedAndMovedBack) {
  Json slices = Json::array();
  for (const double height : {-20.0, -10.0, 0.0, 10.0, 20.0}) {
    slices.push_back(sphere_cut(false, height, 0));
    slices.push_back(sphere_cut(true, height, height == 10 ? 3 : 0));
  }
  const std::string in = write(slices);
  const ProgramRun plain = isostack("reconstruct " + in + " -o " + path("a.stl") + " --json");
  ASSERT_EQ(plain.exit_code, 0) << plain.err;
  const Json before = plain.json()["surfaces"][0]["contradictions"];
  EXPECT_NEAR(before["largest_mismatch_mm"], 3, 0.1);
  EXPECT_GT(plain.json()["surfaces"][0]["softened_constraints"], 0);

  const ProgramRun run = isostack("reconstruct " + in + " --align --align-rotation --aligned " + path("aligned.json") +
                                  " -o " + path("b.stl") + " --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json alignment = run.json()["alignments"][0];
  EXPECT_EQ(alignment["before"], before);
  EXPECT_LT(alignment["after"]["disagreement_mm"], 0.1 * alignment["before"]["disagreement_mm"].get<double>());
  for (const Json& slice : alignment["slices"])
    EXPECT_NEAR(slice["shift_mm"][0], slice["slice"] == "upright 10" ? -3 : 0, 0.3) << slice;

  const ProgramRun again = isostack("reconstruct " + path("aligned.json") + " -o " + path("c.stl"));
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(again.out.find("contradict"), std::string::npos) << again.out;  // the file holds the moved slices
}

TEST_F(AlignCommand, WorstPairsAreListed) {
  const ProgramRun run =
      isostack("reconstruct " + write({sphere_cut(false, 0, 0), sphere_cut(false, 10, 0), sphere_cut(true, 0, 4)}) +
               " -o " + path("a.stl"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("2 of 2 pairs"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("flat 10 and upright 0"), std::string::npos) << run.out;
}

TEST_F(AlignCommand, OnePlaneTwiceIsRefusedByName) {
  const ProgramRun run =
      isostack("reconstruct " + write({sphere_cut(false, 0, 0), sphere_cut(false, 10, 0), sphere_cut(false, 0, 4)}) +
               " -o " + path("a.stl"));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("slices flat 0 and flat 0"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(path("a.stl")));
}

TEST_F(AlignCommand, OptionsThatNeedAlignSayTheyDo) {
  EXPECT_EQ(isostack("reconstruct " + write({sphere_cut(false, 0, 0), sphere_cut(true, 0, 0)}) +
                     " --align-limit 5 -o " + path("a.stl"))
                .exit_code,
            2);
}

}  // namespace
}  // namespace isostack
