#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

namespace isostack::testing_support {

/// What the real program printed and its exit code.
struct ProgramRun {
  int exit_code;
  std::string out, err;
  nlohmann::json json() const { return nlohmann::json::parse(out); }
};

inline std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A folder of its own for each test, empty at its start.
class ProgramTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder = std::filesystem::path(testing::TempDir()) / (std::string("isostack_cli_") + info->test_suite_name() + "_" +
                                                          info->name() + "_" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::string path(const std::string& name) const { return (folder / name).string(); }

  ProgramRun run_command(const std::string& command) const {
    const std::string out = path(".stdout"), err = path(".stderr");
    const int status = std::system((command + " >" + out + " 2>" + err).c_str());
    ProgramRun result{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), file_text(out), file_text(err)};
    std::filesystem::remove(out);
    std::filesystem::remove(err);
    return result;
  }
  ProgramRun isostack(const std::string& arguments) const { return run_command(ISOSTACK_PROGRAM " " + arguments); }

  std::filesystem::path folder;
};

/// Such a folder with the sample, an organ in oblique slices, in "sample".
class SampleTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    ASSERT_EQ(run_command(ISOSTACK_MAKE_PHANTOM " " + path("sample")).exit_code, 0);
  }
  /// Its surface in organ.stl: few constraints and large cells, for tests of what happens to a surface.
  ProgramRun reconstruct_sample(int max_constraints, const std::string& options) const {
    return isostack("reconstruct " + path("sample/series") + " --level 25 --gaussian 1 --largest --max-constraints " +
                    std::to_string(max_constraints) + " --resolution 2 --json " + options + " -o " + path("organ.stl"));
  }
};

}  // namespace isostack::testing_support
