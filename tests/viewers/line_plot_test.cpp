#include "viewers/line_plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

LinePlot simple_plot() {
  return {.title = "Distance <mm> & Dice",
          .x_label = "K",
          .y_label = "mm",
          .lines = {{.name = "a", .points = {{2, 0.3}, {8, 0.7}}}},
          .x_ticks = {}};
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(RoundTicks, TakeInTheRangeInRoundSteps) {
  const auto ticks = round_ticks(0.13, 0.87, 6);
  EXPECT_LE(ticks.front(), 0.13);
  EXPECT_GE(ticks.back(), 0.87);
  for (std::size_t i = 1; i < ticks.size(); ++i) EXPECT_NEAR(ticks[i] - ticks[i - 1], 0.2, 1e-12);
  const auto of_one_value = round_ticks(3, 3, 6);
  EXPECT_LT(of_one_value.front(), 3);
  EXPECT_GT(of_one_value.back(), 3);
}

TEST(LinePlots, HaveALineAMarkerPerPointAndEscapedText) {
  const std::string svg = line_plots_svg({simple_plot()});
  EXPECT_EQ(occurrences(svg, "<polyline"), 2u);  // the line, and its sample in the legend
  EXPECT_EQ(occurrences(svg, "<circle"), 3u);
  EXPECT_NE(svg.find("Distance &lt;mm&gt; &amp; Dice"), std::string::npos);
  EXPECT_EQ(occurrences(line_plots_svg({simple_plot(), simple_plot()}), "<polyline"), 4u);
}

TEST(LinePlots, RefuseWhatCannotBeDrawn) {
  LinePlot endless = simple_plot(), empty = simple_plot();
  endless.lines[0].points[0].y() = INFINITY;
  empty.lines.clear();
  EXPECT_THROW(line_plots_svg({endless}), InputError);
  EXPECT_THROW(line_plots_svg({empty}), InputError);
  EXPECT_THROW(line_plots_svg({}), InputError);
  EXPECT_THROW(save_line_plots({simple_plot()}, std::filesystem::path(testing::TempDir()) / "plot.txt"), InputError);
}

}  // namespace
}  // namespace isostack
