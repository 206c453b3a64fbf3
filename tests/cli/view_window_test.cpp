// The window as a person uses it: keys and clicks sent to it through an X server of its own.
#include <gtest/gtest.h>

#include <cmath>

#include "io/contours/contour_files.h"
#include "tests/cli/program.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::ProgramRun;

constexpr int width = 1000, height = 700, status_height = 104;
constexpr double ball_mm = 30;

/// Contours of a ball on slices of 100 × 100 pixels of 1 mm, and a surface through them.
class ViewWindow : public testing_support::ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (run_command("xdotool --version && xvfb-run --help").exit_code != 0)
      GTEST_SKIP() << "no xdotool or xvfb-run: install what cmake/debian-packages.txt lists";
    SlicePose pose;
    pose.origin_mm = {-50, -50, 0};
    ContourStack ball = testing_support::sphere_cuts(ball_mm, pose, {-24, -16, -8, 0, 8, 16, 24}, 90);
    for (ContourSlice& slice : ball.slices) slice.size_pixels = {100, 100};
    write_contours({ball}, path("ball.json"));
    ASSERT_EQ(isostack("reconstruct " + path("ball.json") + " --resolution 3 -o " + path("ball.stl")).exit_code, 0);
  }

  /// Pixel of the window, from its top left, at which a point (x, y) of the shown slice is: it fills the part of the
  /// window right of 58 % of its width and above the text, 4 % larger than needed.
  std::string pixel_at(double x_mm, double y_mm) const {
    const double panel_left = 0.58 * width, panel_height = height - status_height;
    const double mm_per_pixel = 1.04 * std::max(100 / panel_height, 100 / (width - panel_left));
    const double x = (panel_left + width) / 2 + (x_mm + 0.5) / mm_per_pixel;
    const double y = panel_height / 2 + (y_mm + 0.5) / mm_per_pixel;
    return std::to_string(std::lround(x)) + " " + std::to_string(std::lround(y));
  }

  /// Opens a window on `input`, does what the lines of shell say, and waits for the window to close.
  ProgramRun in_window(const std::string& input, const std::string& lines) const {
    std::ofstream(path("session.sh")) << "set -e\n"
                                      << ISOSTACK_PROGRAM " view " << input << " --title ball --json --size " << width
                                      << "x" << height << " >window.out 2>window.err &\n"
                                      << R"(
program=$!
window=$(xdotool search --sync --onlyvisible --name 'isostack.*ball' | head -1)
key() { xdotool key --delay 60 --window "$window" "$@" || true; sleep 0.1; }  # q takes the window from under it
click() { xdotool mousemove --window "$window" "$1" "$2" sleep 0.1 click 1 sleep 0.1; }
drag() {
  xdotool mousemove --window "$window" "$1" "$2" sleep 0.1 mousedown 1 sleep 0.1
  xdotool mousemove --window "$window" "$3" "$4" sleep 0.2 mouseup 1 sleep 0.2
}
saved() {  # saves the session until it says so
  for _ in $(seq 300); do key ctrl+s; grep -q "$1" session.json && return; sleep 0.1; done
  return 1
}
saved '"layers"'  # it listens now
)" << lines << "\nwait $program\n";
    ProgramRun run =
        run_command("cd " + folder.string() + " && timeout 120 xvfb-run -a -s '-screen 0 1200x900x24' bash session.sh");
    run.out = testing_support::file_text(folder / "window.out");
    const std::string of_window = testing_support::file_text(folder / "window.err");
    run.err = run.exit_code == 0 ? of_window : run.err + of_window;  // xdotool has much to say
    return run;
  }
  nlohmann::json saved_state() const {
    return nlohmann::json::parse(testing_support::file_text(folder / "session.json"))["state"];
  }
};

TEST_F(ViewWindow, ScrollsPicksMeasuresEditsSolvesAndSaves) {
  const std::string files = "ball.json ball.stl --session session.json --resolution 3 ";
  const ProgramRun run = in_window(files, "key Up Up Down Down\nclick " + pixel_at(10, 5) + "\nkey m\nclick " +
                                              pixel_at(-12, 0) + "\nclick " + pixel_at(12, 0) + "\nkey e\ndrag " +
                                              pixel_at(ball_mm, 0) + " " + pixel_at(36, 0) + R"(
key Return
for _ in 1 2 3 4 5 6; do key Up Down; done
saved '"is_solved": true'
key ctrl+p
sleep 0.5
key q)");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.err.empty()) << run.err;
  const nlohmann::json window = run.json()["window"], state = saved_state();
  EXPECT_EQ(state["plane"], 3);
  ASSERT_EQ(state["picks_mm"].size(), 1U);
  const double pixel_mm = 0.25;  // a click falls on a whole pixel of the screen
  EXPECT_NEAR(state["picks_mm"][0][0].get<double>(), 10, pixel_mm);
  EXPECT_NEAR(state["picks_mm"][0][1].get<double>(), 5, pixel_mm);
  EXPECT_NEAR(state["picks_mm"][0][2].get<double>(), 0, 1e-9);
  ASSERT_EQ(state["measurements"].size(), 1U);
  EXPECT_NEAR(state["measurements"][0]["length_mm"].get<double>(), 24, 2 * pixel_mm);
  ASSERT_EQ(state["edits"].size(), 1U);
  EXPECT_EQ(state["edits"][0][0]["kind"], "move_point");
  EXPECT_NEAR(state["edits"][0][0]["to_mm"][0].get<double>(), 50 + 36, pixel_mm);
  EXPECT_GT(window["events_while_busy"].get<int>(), 0) << "keys were pressed while it solved";
  RecordProperty("slowest_answer_while_busy_ms", window["slowest_answer_while_busy_ms"].dump());
  EXPECT_EQ(testing_support::file_text(folder / "session.png").substr(1, 3), "PNG");
}

TEST_F(ViewWindow, ASavedSessionOpensAgainAndClosesWhileItSolves) {
  std::ofstream(folder / "session.json") << R"({"format": "isostack-view", "version": 1,
    "inputs": ["ball.json", "ball.stl"], "title": "ball",
    "state": {"plane": 1, "is_solved": true, "edits": [[{"kind": "drop_slice", "organ": 0, "slice": 2}]]}})";
  const ProgramRun run = in_window("session.json", "key Up\nkey ctrl+s\nkey q");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.err.empty()) << run.err;
  EXPECT_EQ(saved_state()["plane"], 2);
  EXPECT_EQ(saved_state()["edits"].size(), 1U);
}

TEST_F(ViewWindow, LosingItsServerWhileItSolvesEndsTheProgram) {
  const ProgramRun run = in_window("ball.json ball.stl --session session.json", R"(key Return
xdotool windowkill "$window")");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.err.empty()) << run.err;
}

TEST_F(ViewWindow, WithoutADisplayItSaysHowToGetOne) {
  const ProgramRun run = run_command("env -u DISPLAY " ISOSTACK_PROGRAM " view " + path("ball.stl"));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("xvfb-run"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace isostack
