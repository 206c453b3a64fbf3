// Recorded runs through the real program: --record, run, what is kept and what is not.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cli/program.h"

namespace isostack {
namespace {

using testing_support::file_text;
using testing_support::ProgramRun;

class PipelineTest : public testing_support::SampleTest {
 protected:
  void SetUp() override {
    SampleTest::SetUp();
    const std::string record = " --record " + path("p.json");
    const ProgramRun segment = isostack("segment " + path("sample/series") + " --level 25 --gaussian 1 --largest -o " +
                                        path("contours.json") + record);
    ASSERT_EQ(segment.exit_code, 0) << segment.err;
    const ProgramRun reconstruct = isostack("reconstruct " + path("contours.json") +
                                            " --max-constraints 600 --resolution 3 -o " + path("organ.stl") + record);
    ASSERT_EQ(reconstruct.exit_code, 0) << reconstruct.err;
  }
  nlohmann::json pipeline() const { return nlohmann::json::parse(file_text(path("p.json"))); }
  void write(const nlohmann::json& json) const { std::ofstream(path("p.json")) << json.dump(2); }

  /// "kept" or "ran" of each step.
  std::vector<std::string> states(const std::string& options = "") const {
    const ProgramRun run = isostack("run " + path("p.json") + " --json " + options);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    std::vector<std::string> result;
    if (run.exit_code != 0) return result;
    const nlohmann::json told = run.json();
    for (const auto& step : told["steps"]) result.push_back(step["state"]);
    return result;
  }
  void expect_refusal(const std::string& options, const std::vector<std::string>& words) const {
    const ProgramRun run = isostack("run " + path("p.json") + " " + options);
    EXPECT_EQ(run.exit_code, 3) << run.err;
    for (const std::string& word : words)
      EXPECT_NE(run.err.find(word), std::string::npos) << word << " not in: " << run.err;
  }
};

using States = std::vector<std::string>;

TEST_F(PipelineTest, RecordsWhatWasReadGivenAndWritten) {
  const nlohmann::json recorded = pipeline();
  EXPECT_EQ(recorded["format"], "isostack-pipeline");
  EXPECT_EQ(recorded["inputs"]["series"]["path"], path("sample/series"));
  ASSERT_EQ(recorded["steps"].size(), 2U);
  const nlohmann::json &segment = recorded["steps"][0], &reconstruct = recorded["steps"][1];
  EXPECT_EQ(segment["options"]["IN"], nlohmann::json({"@series"}));
  EXPECT_EQ(segment["options"]["level"], 25);
  EXPECT_EQ(segment["options"]["largest"], true);
  EXPECT_EQ(segment["writes"], nlohmann::json({path("contours.json")}));
  EXPECT_EQ(reconstruct["options"]["IN"], nlohmann::json({path("contours.json")})) << "an earlier step's output";
  EXPECT_EQ(reconstruct["defaults"]["align-limit"], 10);
}

TEST_F(PipelineTest, RecordingAStepAgainReplacesIt) {
  ASSERT_EQ(isostack("reconstruct " + path("contours.json") + " --max-constraints 500 --resolution 3 -o " +
                     path("organ.stl") + " --record " + path("p.json"))
                .exit_code,
            0);
  ASSERT_EQ(pipeline()["steps"].size(), 2U);
  EXPECT_EQ(pipeline()["steps"][1]["options"]["max-constraints"], 500);
}

TEST_F(PipelineTest, TheSameBytesComeOutAgain) {
  const std::string surface = file_text(path("organ.stl"));
  ASSERT_FALSE(surface.empty());
  std::filesystem::remove(path("organ.stl"));
  std::filesystem::remove(path("contours.json"));
  EXPECT_EQ(states(), (States{"ran", "ran"}));
  EXPECT_EQ(file_text(path("organ.stl")), surface);
}

TEST_F(PipelineTest, OnlyWhatHasChangedRunsAgain) {
  EXPECT_EQ(states(), (States{"ran", "ran"})) << "recording leaves no state";
  EXPECT_EQ(states(), (States{"kept", "kept"}));
  std::filesystem::remove(path("organ.stl"));
  EXPECT_EQ(states(), (States{"kept", "ran"})) << "an output is missing";
  std::ofstream(path("organ.stl")) << "something else";
  EXPECT_EQ(states(), (States{"kept", "ran"})) << "an output was changed";

  nlohmann::json changed = pipeline();
  changed["steps"][1]["options"]["resolution"] = 4;
  write(changed);
  EXPECT_EQ(states("--dry-run"), (States{"kept", "would run"}));
  EXPECT_EQ(states(), (States{"kept", "ran"})) << "an option was changed";

  changed["steps"][0]["options"]["level"] = 26;
  write(changed);
  EXPECT_EQ(states("--dry-run"), (States{"would run", "would run"}));
  EXPECT_EQ(states(), (States{"ran", "ran"})) << "the contours came out otherwise";
  EXPECT_EQ(states("--force"), (States{"ran", "ran"}));
}

TEST_F(PipelineTest, AStepAfterOneThatCameOutTheSameIsKept) {
  EXPECT_EQ(states(), (States{"ran", "ran"}));
  std::filesystem::remove(path("contours.json"));
  EXPECT_EQ(states(), (States{"ran", "kept"}));
}

TEST_F(PipelineTest, RunsOnOtherInputsIntoAnotherFolder) {
  ASSERT_EQ(run_command(ISOSTACK_MAKE_PHANTOM " " + path("other")).exit_code, 0);
  const auto before = std::filesystem::last_write_time(path("organ.stl"));
  nlohmann::json relative = pipeline();
  relative["steps"][0]["options"]["output"] = "contours.json";
  relative["steps"][0]["writes"] = {"contours.json"};
  relative["steps"][1]["options"]["IN"] = {"contours.json"};
  relative["steps"][1]["options"]["output"] = "surfaces/organ.stl";
  relative["steps"][1]["writes"] = nlohmann::json::array();  // as one written by hand
  write(relative);
  const std::string there = "--input series=" + path("other/series") + " --output-dir " + path("case2");
  EXPECT_EQ(states(there), (States{"ran", "ran"}));
  EXPECT_EQ(file_text(path("case2/surfaces/organ.stl")), file_text(path("organ.stl"))) << "the same phantom";
  EXPECT_EQ(std::filesystem::last_write_time(path("organ.stl")), before);
  EXPECT_EQ(states(there), (States{"kept", "kept"}));
}

TEST_F(PipelineTest, StepsRunInTheOrderTheirFilesAsk) {
  nlohmann::json turned = pipeline();
  std::swap(turned["steps"][0], turned["steps"][1]);
  write(turned);
  std::filesystem::remove(path("contours.json"));
  EXPECT_EQ(states(), (States{"ran", "ran"}));
}

TEST_F(PipelineTest, MistakesAreNamedWithTheirLine) {
  const nlohmann::json good = pipeline();
  const auto line_of = [&](const std::string& text) {
    std::istringstream lines(file_text(path("p.json")));
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number)
      if (line.find(text) != std::string::npos) return "line " + std::to_string(number);
    return std::string("no line has it");
  };
  nlohmann::json bad = good;
  bad["steps"][0]["colour"] = "red";
  write(bad);
  expect_refusal("", {"p.json", line_of("colour"), "unknown"});

  bad = good;
  bad["steps"][1]["options"]["no-such-option"] = 3;
  write(bad);
  expect_refusal("", {"no-such-option", "reconstruct"});

  bad = good;
  bad["steps"][1]["options"]["kernel"] = "quartic";
  write(bad);
  expect_refusal("", {"quartic"});

  bad = good;
  bad["steps"][0]["options"]["IN"] = {"@nobody"};
  write(bad);
  expect_refusal("", {"nobody", line_of("\"IN\"")});

  bad = good;
  bad["steps"][0]["command"] = "run";
  write(bad);
  expect_refusal("", {"no command 'run'"});

  bad = good;
  bad["steps"][0]["options"]["IN"] = {path("organ.stl")};
  write(bad);
  expect_refusal("", {"circle", "segment, reconstruct"});

  write(good);
  expect_refusal("--input head=x", {"head", "series"});
  expect_refusal("--input series=" + path("nowhere"), {"nowhere", "--input series="});
  std::ofstream(path("p.json")) << "{\n\"format\": \"isostack-pipeline\",\n\"version\": 1,,\n}";
  expect_refusal("", {"line 3", "JSON"});
  EXPECT_EQ(isostack("run " + path("p.json") + " --input series").exit_code, 2);
}

TEST_F(PipelineTest, AFailedStepIsNamedAndTheNextRunGoesOnThere) {
  const nlohmann::json good = pipeline();
  nlohmann::json bad = good;
  bad["steps"][1]["options"]["memory"] = 1e-6;
  write(bad);
  const ProgramRun failed = isostack("run " + path("p.json"));
  EXPECT_EQ(failed.exit_code, 4) << failed.err;
  EXPECT_NE(failed.err.find("step 'reconstruct' failed"), std::string::npos) << failed.err;
  write(good);
  EXPECT_EQ(states(), (States{"kept", "ran"}));
}

TEST_F(PipelineTest, KilledRunsGoOnAndEndAsUndisturbedOnes) {
  const std::string surface = file_text(path("organ.stl"));
  for (int i = 1; i <= 10; ++i) {  // from during start-up to after the end of a run of some 0.7 s
    std::filesystem::remove(path("organ.stl"));
    run_command("timeout -s KILL " + std::to_string(0.08 * i) + " " ISOSTACK_PROGRAM " run " + path("p.json"));
    if (std::filesystem::exists(path("organ.stl"))) {
      EXPECT_EQ(file_text(path("organ.stl")), surface) << "half-written";
    }
  }
  std::filesystem::remove(path("organ.stl"));
  EXPECT_EQ(states().back(), "ran");
  EXPECT_EQ(file_text(path("organ.stl")), surface);
}

TEST_F(PipelineTest, RecordingInsideARunOrIntoAnotherFileIsRefused) {
  EXPECT_EQ(isostack("run " + path("p.json") + " --record " + path("q.json")).exit_code, 3);
  const ProgramRun run = isostack("info " + path("sample/series") + " --record " + path("contours.json"));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("not an isostack pipeline"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace isostack
