// `isostack morph --method subdivision` of figures.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cli/program.h"

namespace isostack {
namespace {

namespace fs = std::filesystem;
using testing_support::ProgramRun;

class MorphSubdivision : public testing_support::ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    ASSERT_EQ(run_command(ISOSTACK_MAKE_SHAPES " " + path("shapes")).exit_code, 0);
    fs::create_directory(path("out"));
  }
  std::string shape(const std::string& name) const { return path("shapes/" + name); }
  ProgramRun morph(const std::string& arguments) const {
    return isostack("morph --method subdivision --json --frames 3 " + arguments + " -o " + path("out/frames.json"));
  }
  void features(const std::string& rest) const {
    std::ofstream(path("f.json")) << R"({"format": "isostack-features", "version": 1, )" + rest + "}";
  }
  void expect_refusal(const std::string& arguments, const std::vector<std::string>& words, int exit_code = 3) const {
    const ProgramRun run = morph(arguments);
    EXPECT_EQ(run.exit_code, exit_code) << arguments << '\n' << run.err;
    for (const std::string& word : words)
      EXPECT_NE(run.err.find(word), std::string::npos) << word << " not in: " << run.err;
    EXPECT_TRUE(fs::is_empty(path("out"))) << arguments;
  }
};

TEST_F(MorphSubdivision, TellsHowEachLevelWent) {
  const ProgramRun run = morph(shape("eight.json") + " " + shape("seven.json") + " --key-shape " +
                               shape("eight_to_seven.json") + " --levels 3 -o " + path("spacetime.stl"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json result = run.json();
  ASSERT_EQ(result["levels"].size(), 4U);
  for (const nlohmann::json& level : result["levels"]) {
    EXPECT_LE(level["energy"], level["first_energy"]);
    EXPECT_EQ(level["residual_mm"], 0);
  }
  EXPECT_EQ(result["frames"][0]["holes"], 2);
  EXPECT_EQ(result["frames"][2]["holes"], 0);
  EXPECT_TRUE(fs::exists(path("spacetime.stl")));
}

TEST_F(MorphSubdivision, RefusesFilesThatNameWhatIsNotThere) {
  const std::string figures = shape("pointed.json") + " " + shape("triangle.json");
  const std::string with_features = figures + " --features " + path("f.json");
  features(R"("features": [{"from": {"shape": 0, "vertex": 99}, "to": {"shape": 1, "vertex": 0}}])");
  expect_refusal(with_features, {"pointed.json", "vertex 99", "has 10"});
  features(R"("features": [{"from": {"shape": 0, "place_mm": [3, 3]}, "to": {"shape": 1, "vertex": 0}}])");
  expect_refusal(with_features, {"pointed.json", "no contour is near"});
  features(R"("features": [{"from": {"shape": 0}}])");
  expect_refusal(with_features, {"f.json", "feature 1", "place_mm"});
  features(R"("transitions": [{"level": 9, "t": 0.5, "place_mm": [3, 3], "to_mm": [4, 4]}])");
  expect_refusal(with_features, {"level 9 of 4"});
  features(R"("warp": [[0.5], [0.6]])");
  expect_refusal(with_features, {"warp", "16"});
  expect_refusal(figures + " --features " + shape("pointed.json"),
                 {"pointed.json", "not a file of the format isostack-features"});
}

TEST_F(MorphSubdivision, RefusesKeyShapesAndOptionsThatDoNotFit) {
  const std::string figures = shape("eight.json") + " " + shape("seven.json");
  const std::string with_key = figures + " --key-shape " + shape("eight_to_seven.json");
  expect_refusal(with_key + " --key-shape-at 1.2", {"eight_to_seven.json", "1.2"});
  expect_refusal(with_key + " --key-shape-at 0.2 --key-shape-at 0.3", {"--key-shape-at", "2 times"});
  expect_refusal(figures + " --sweep 1,0,0", {"--sweep"});
  expect_refusal(figures + " --levels 0", {"--levels"}, 2);
  const ProgramRun blend = isostack("morph --method blend --sharp-angle 30 " + figures + " -o " + path("out/frames"));
  EXPECT_EQ(blend.exit_code, 2);
  EXPECT_NE(blend.err.find("belong to --method subdivision"), std::string::npos) << blend.err;
}

}  // namespace
}  // namespace isostack
