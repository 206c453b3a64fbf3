#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace isostack {

/// Points joined in their order, with a marker at each.
struct PlotLine {
  std::string name;  ///< in the legend
  std::vector<Eigen::Vector2d> points;
  int colour = -1;  ///< number of a colour, repeating after eight; -1: the line's place in the plot
  int dashes = 0;   ///< 0 solid, 1 dashed, 2 dotted, 3 dash-dotted; also chooses the marker
};

/// One pair of axes. Both run over round numbers that take in all points.
struct LinePlot {
  std::string title, x_label, y_label;
  std::vector<PlotLine> lines;
  std::vector<double> x_ticks;  ///< where to label the x axis; empty: at round numbers
  bool from_zero = false;       ///< the y axis starts at 0
};

struct LinePlotOptions {
  int width_pixels = 560;  ///< of each plot, its legend included
  int height_pixels = 400;
};

/// The plots side by side as one SVG picture on white, text as text. Throws InputError when there is no plot, a plot
/// has no point, or a coordinate is not a finite number.
std::string line_plots_svg(const std::vector<LinePlot>& plots, const LinePlotOptions& options = {});

/// The same as a file, whole or not at all. Throws InputError also when it cannot be written or is not called .svg.
void save_line_plots(const std::vector<LinePlot>& plots, const std::filesystem::path& svg,
                     const LinePlotOptions& options = {});

/// Round numbers (1, 2 or 5 times a power of ten apart) of which the first is at most `low`, the last at least `high`.
std::vector<double> round_ticks(double low, double high, int about);

}  // namespace isostack
