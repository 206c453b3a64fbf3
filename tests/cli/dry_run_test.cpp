#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace isostack {
namespace {

using testing_support::ProgramRun;
using testing_support::SampleTest;

class DryRun : public SampleTest {
 protected:
  std::string contours() {
    if (!std::filesystem::exists(path("organ.json"))) {
      EXPECT_EQ(
          isostack("segment " + path("sample/series") + " --level 25 --gaussian 1 -o " + path("organ.json")).exit_code,
          0);
    }
    return path("organ.json");
  }

  /// The most memory the program itself held, by the system's account of the process.
  std::size_t measured_peak(const std::string& options) {
    const std::string words = std::string(ISOSTACK_PROGRAM) + " reconstruct " + contours() + " " + options + " -o " +
                              path("organ.ply") + " --quiet >/dev/null";
    const pid_t child = fork();
    if (child == 0) {
      execl("/bin/sh", "sh", "-c", ("exec " + words).c_str(), nullptr);
      std::_Exit(127);
    }
    int status = 0;
    rusage usage{};
    EXPECT_EQ(wait4(child, &status, 0, &usage), child);
    EXPECT_EQ(status, 0);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  }

  void expect_predicted(const std::string& options, const std::string& solver) {
    const ProgramRun run = isostack("reconstruct " + contours() + " " + options + " --dry-run --json");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const nlohmann::json result = run.json();
    EXPECT_EQ(result["predictions"][0]["solver"], solver);
    EXPECT_FALSE(result.contains("outputs"));
    const std::size_t predicted = result["predicted_process_bytes"], peak = measured_peak(options);
    EXPECT_LE(peak, predicted);
    EXPECT_GE(3 * peak, predicted);
  }
};

TEST_F(DryRun, PredictsThePeakOfADenseSolve) { expect_predicted("--max-constraints 6000 --threads 2", "dense"); }

TEST_F(DryRun, PredictsThePeakOfAFastSolve) { expect_predicted("--threads 2", "fast"); }

TEST_F(DryRun, CountsWhatTheRunThenHas) {
  const std::string options = " --max-constraints 1500 --resolution 4";
  const nlohmann::json predicted = isostack("reconstruct " + contours() + options + " --dry-run --json").json();
  const nlohmann::json done =
      isostack("reconstruct " + contours() + options + " --json -o " + path("organ.ply")).json();
  const nlohmann::json &before = predicted["predictions"][0], &after = done["surfaces"][0];
  EXPECT_EQ(before["contour_points"], after["contour_points"]);
  EXPECT_EQ(before["boundary_constraints"], after["boundary_constraints"]);
  EXPECT_LE(before["constraints"], after["constraints"]);
  EXPECT_GE(before["most_constraints"], after["constraints"]);
  EXPECT_EQ(before["contours"], predicted["organs"][0]["contours"]);
  // Each cell that the surface passes has about one vertex; the estimate is rather too large.
  const double vertices = after["surface"]["triangles"].get<double>() / 2;
  EXPECT_GE(before["cells"], 0.8 * vertices);
  EXPECT_LE(before["cells"], 2 * vertices);
}

TEST_F(DryRun, RefusesAsTheRunDoes) {
  const ProgramRun dry = isostack("reconstruct " + contours() + " --memory 0.01 --dry-run");
  const ProgramRun run = isostack("reconstruct " + contours() + " --memory 0.01 -o " + path("organ.ply"));
  EXPECT_EQ(dry.exit_code, 4);
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_EQ(dry.err, run.err);
}

TEST_F(DryRun, NeedsNoOutputAndWritesNone) {
  EXPECT_EQ(isostack("reconstruct " + contours() + " --max-constraints 300").exit_code, 2);
  const ProgramRun dry = isostack("reconstruct " + contours() + " --max-constraints 600 --dry-run --align --aligned " +
                                  path("moved.vtp") + " -o " + path("organ.ply"));
  EXPECT_EQ(dry.exit_code, 0) << dry.err;
  EXPECT_FALSE(std::filesystem::exists(path("organ.ply")));
  EXPECT_FALSE(std::filesystem::exists(path("moved.vtp")));
  EXPECT_EQ(isostack("reconstruct " + contours() + " --dry-run --record " + path("p.json")).exit_code, 2);
}

TEST_F(DryRun, KnowsThePapersRecipe) {
  const ProgramRun run = isostack("reconstruct " + path("sample/series") +
                                  " --level 25 --preset turk-obrien --max-constraints 900 --dry-run --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_LE(run.json()["predictions"][0]["constraints"], 900);
}

class Batch : public SampleTest {};

TEST_F(Batch, RunsEachCommandInAProcessOfItsOwn) {
  std::ofstream(path("commands")) << R"(["info", ")" << path("sample/series") << "\"]\n"
                                  << R"(["info", ")" << path("nothing") << "\"]\n"
                                  << R"(["measure"])"
                                  << "\n"
                                  << R"(["info", ")" << path("sample/series") << "\", \"--json\"]\n";
  const ProgramRun run = isostack("batch < " + path("commands"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  std::istringstream lines(run.out);
  std::vector<nlohmann::json> results;
  for (std::string line; std::getline(lines, line);) results.push_back(nlohmann::json::parse(line));
  ASSERT_EQ(results.size(), 4U);
  EXPECT_EQ(results[0]["exit_code"], 0);
  EXPECT_EQ(results[0]["stdout"], isostack("info " + path("sample/series")).out);
  EXPECT_EQ(results[1]["exit_code"], 3);
  EXPECT_NE(results[1]["stderr"].get<std::string>().find("nothing"), std::string::npos);
  EXPECT_EQ(results[2]["exit_code"], 2);
  EXPECT_TRUE(nlohmann::json::parse(results[3]["stdout"].get<std::string>()).contains("isostack"));
  EXPECT_GT(results[3]["peak_bytes"], 1e6);
}

TEST_F(Batch, NamesALineThatIsNoCommand) {
  std::ofstream(path("commands")) << "[\"info\"\n";
  const ProgramRun run = isostack("batch < " + path("commands"));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("line 1"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace isostack
