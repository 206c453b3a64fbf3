// segment's seeds, recipes and distances through the real program; run.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cli/program.h"

namespace isostack {
namespace {

using testing_support::file_text;
using testing_support::ProgramRun;

class SegmentRecipe : public testing_support::SampleTest {
 protected:
  void SetUp() override {
    SampleTest::SetUp();
    series = path("sample/series");
  }
  void expect_refusal(const std::string& arguments, const std::vector<std::string>& words) {
    const ProgramRun run = isostack(arguments);
    EXPECT_EQ(run.exit_code, 3) << run.err;
    for (const std::string& word : words)
      EXPECT_NE(run.err.find(word), std::string::npos) << word << " not in: " << run.err;
  }
  std::string series;
};

TEST_F(SegmentRecipe, SavedRecipeRunsAgainToTheSameContours) {
  const ProgramRun first =
      isostack("segment " + series + " --range 25,1000 --start fill-holes --curvature 0.5 --largest -o " +
               path("a.json") + " --save-recipe " + path("r.json"));
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const std::string contours = file_text(path("a.json"));
  std::filesystem::remove(path("a.json"));
  const ProgramRun again = isostack("run " + path("r.json"));
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(file_text(path("a.json")), contours);
  EXPECT_EQ(again.out, first.out);

  const ProgramRun other = isostack("segment " + series + " --recipe " + path("r.json") + " -o " + path("b.json"));
  ASSERT_EQ(other.exit_code, 0) << other.err;
  EXPECT_EQ(file_text(path("b.json")), contours);
}

TEST_F(SegmentRecipe, TheCommandLineOverridesTheRecipe) {
  // A level excludes the recipe's Otsu; a curvature replaces its own.
  std::ofstream(path("r.json")) << R"({"format": "isostack-recipe", "version": 1, "command": "segment",
    "options": {"otsu": true, "curvature": 3, "largest": true}})";
  ASSERT_EQ(isostack("segment " + series + " --level 25 --curvature 0 --recipe " + path("r.json") + " -o " +
                     path("a.json") + " --save-recipe " + path("saved.json"))
                .exit_code,
            0);
  const auto options = nlohmann::json::parse(file_text(path("saved.json")))["options"];
  EXPECT_EQ(options, nlohmann::json({{"level", 25}, {"curvature", 0}, {"largest", true}}));
}

TEST_F(SegmentRecipe, BadRecipesAreNamed) {
  const std::string segment = "segment " + series + " -o " + path("a.json") + " --recipe ";
  expect_refusal(segment + "no-such", {"no-such", "bone-ct", "blood-pool-mr"});
  const auto refuse = [&](const std::string& text, const std::vector<std::string>& words) {
    std::ofstream(path("r.json")) << text;
    expect_refusal(segment + path("r.json"), words);
  };
  refuse("{", {"r.json", "JSON"});
  refuse(R"({"format": "other"})", {"r.json", "not an isostack recipe"});
  const std::string head = R"({"format": "isostack-recipe", "version": 1, "command": "segment", "options": )";
  refuse(head + R"({"levle": 3}})", {"r.json", "levle"});
  refuse(head + R"({"level": "bright"}})", {"r.json", "level"});
  refuse(head + R"({"level": {}}})", {"r.json", "level"});
  refuse(R"({"format": "isostack-recipe", "version": 1, "command": "reconstruct"})", {"reconstruct"});
  expect_refusal("run " + path("r.json"), {"r.json", "no input"});
  EXPECT_FALSE(std::filesystem::exists(path("a.json")));
}

TEST_F(SegmentRecipe, BuiltInRecipesAreComplete) {
  for (const std::string name : {"bone-ct", "skin", "soft-tissue-ct", "blood-pool-mr"}) {
    // No option is refused; the seed is beside the sample's images, or its gaps are uneven for --volume.
    expect_refusal("segment " + series + " --seed 9999,0,0,organ -o " + path("a.json") + " --recipe " + name,
                   {name == "soft-tissue-ct" ? "leave out `volume`" : "seed 9999,0,0 (organ)"});
  }
}

TEST_F(SegmentRecipe, SeedsThatAreNoPlacesAreNamed) {
  for (const std::string seed : {"1,2", "a,b,c", "1,2,x", ""})
    expect_refusal("segment " + series + " --level 25 -o " + path("a.json") + " --seed '" + seed + "'", {"--seed"});
  expect_refusal("segment " + series + " --seed 0,0,9999 -o " + path("a.json"), {"seed 0,0,9999", "LPS"});
}

TEST_F(SegmentRecipe, DistancesNeedEvenSlices) {
  expect_refusal("segment " + series + " --level 25 -o " + path("a.json") + " --distance " + path("d.nii.gz"),
                 {"d.nii.gz", "evenly"});
}

}  // namespace
}  // namespace isostack
