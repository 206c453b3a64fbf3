#include "cli/morph_quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "recon/geometry/errors.h"
#include "recon/metrics/frame_quality.h"
#include "recon/metrics/mesh_measures.h"
#include "viewers/line_plot.h"

namespace isostack::cli {

namespace {

struct TimedQuality {
  double t = 0;
  bool is_key_shape = false;  ///< given, not made
  FrameQuality quality;
};

/// Topology between the frames `after - 1` and `after` differs.
struct TopologyChange {
  std::size_t after;
};

nlohmann::json to_json(const MorphFrame& frame, const FrameQuality& quality) {
  nlohmann::json entry = {{"t", frame.t},
                          {"weights", std::vector<double>(frame.weights.begin(), frame.weights.end())},
                          {"components", quality.components}};
  if (frame.is_figure()) {
    entry.update(
        {{"holes", quality.holes},
         {"area_mm2", quality.content},
         {"perimeter_mm", quality.boundary},
         {"curvature_per_mm", {{"lowest", quality.lowest_curvature}, {"highest", quality.highest_curvature}}}});
    return entry;
  }
  entry.update({{"genus", quality.holes},
                {"watertight", measure(frame.body()).watertight()},
                {"triangles", frame.body().triangles.size()},
                {"volume_mm3", quality.content},
                {"area_mm2", quality.boundary},
                {"mean_curvature_per_mm", {{"p1", quality.lowest_curvature}, {"p99", quality.highest_curvature}}}});
  return entry;
}

std::vector<TopologyChange> changes_in(const std::vector<TimedQuality>& frames) {
  std::vector<TopologyChange> changes;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const FrameQuality &before = frames[i - 1].quality, &after = frames[i].quality;
    if (before.components != after.components || before.holes != after.holes) changes.push_back({i});
  }
  return changes;
}

/// Over frames between the key shapes that no change can be near, wherever it is between its two frames: there pinches
/// are as they must be.
std::optional<double> largest_curvature(const std::vector<TimedQuality>& frames,
                                        const std::vector<TopologyChange>& changes) {
  constexpr double near = 0.02;
  std::optional<double> largest;
  for (const TimedQuality& frame : frames) {
    const bool is_near = std::any_of(changes.begin(), changes.end(), [&](const TopologyChange& change) {
      return frame.t > frames[change.after - 1].t - near && frame.t < frames[change.after].t + near;
    });
    if (!is_near && !frame.is_key_shape && frame.quality.components > 0)
      largest = std::max(largest.value_or(0), frame.quality.largest_curvature());
  }
  return largest;
}

std::string table(const std::vector<TimedQuality>& frames, bool figures) {
  std::string text = figures ? "     t  parts  holes    area mm2  perimeter mm   curvature /mm\n"
                             : "     t  parts  genus  volume mm3      area mm2   mean curvature /mm (1 to 99 %)\n";
  for (const TimedQuality& frame : frames) {
    const FrameQuality& q = frame.quality;
    text += fmt::format("{:6.4g}  {:5}  {:5}  {:10.6g}  {:12.6g}  {:7.3f} to {:.3f}\n", frame.t, q.components, q.holes,
                        q.content, q.boundary, q.lowest_curvature, q.highest_curvature);
  }
  return text;
}

LinePlot plot_over_t(const std::string& title, const std::string& y_label) {
  return {.title = title, .x_label = "t", .y_label = y_label, .lines = {}, .x_ticks = {}};
}

void save_plot(const std::vector<TimedQuality>& frames, bool figures, const std::filesystem::path& path) {
  const auto line = [&](const std::string& name, auto FrameQuality::*value, int dashes = 0) {
    PlotLine result{.name = name, .points = {}, .dashes = dashes};
    for (const TimedQuality& frame : frames)
      result.points.emplace_back(frame.t, static_cast<double>(frame.quality.*value));
    return result;
  };
  LinePlot topology = plot_over_t("Topology", "count");
  topology.lines = {line("parts", &FrameQuality::components),
                    line(figures ? "holes" : "genus", &FrameQuality::holes, 1)};
  topology.from_zero = true;
  LinePlot size = plot_over_t(figures ? "Area" : "Volume", figures ? "mm²" : "mm³");
  size.lines = {line(figures ? "area" : "volume", &FrameQuality::content)};
  size.from_zero = true;
  LinePlot boundary = plot_over_t(figures ? "Perimeter" : "Surface area", figures ? "mm" : "mm²");
  boundary.lines = {line(figures ? "perimeter" : "area", &FrameQuality::boundary)};
  boundary.from_zero = true;
  LinePlot curvature = plot_over_t(figures ? "Curvature" : "Mean curvature", "1/mm");
  curvature.lines = {line(figures ? "highest" : "99 %", &FrameQuality::highest_curvature),
                     line(figures ? "lowest" : "1 %", &FrameQuality::lowest_curvature, 1)};
  save_line_plots({topology, size, boundary, curvature}, path, {.width_pixels = 440, .height_pixels = 320});
}

}  // namespace

void require_plot_name(const std::filesystem::path& plot) {
  if (plot.empty()) return;
  if (plot.extension() != ".svg")
    throw InputError(plot.string(), "plots are written as SVG only", "let the name end in .svg");
  if (plot.has_parent_path() && !std::filesystem::is_directory(plot.parent_path()))
    throw InputError(plot.string(), "its folder does not exist", "create " + plot.parent_path().string());
}

void report_quality(const std::vector<MorphFrame>& frames, const std::filesystem::path& plot, Session& session) {
  std::vector<TimedQuality> qualities;
  for (const MorphFrame& frame : frames) {
    qualities.push_back(
        {.t = frame.t, .is_key_shape = frame.weights.maxCoeff() > 1 - 1e-9, .quality = frame_quality(frame.shape)});
    session.result["frames"].push_back(to_json(frame, qualities.back().quality));
  }
  const bool figures = frames.front().is_figure();
  const std::vector<TopologyChange> changes = changes_in(qualities);
  session.result["topology_changes"] = nlohmann::json::array();
  for (const TopologyChange& change : changes)
    session.result["topology_changes"].push_back({qualities[change.after - 1].t, qualities[change.after].t});
  const std::optional<double> largest = largest_curvature(qualities, changes);
  session.result["largest_curvature_per_mm"] = largest ? nlohmann::json(*largest) : nlohmann::json(nullptr);
  session.text += table(qualities, figures);
  if (plot.empty()) return;
  save_plot(qualities, figures, plot);
  session.wrote(plot);
}

}  // namespace isostack::cli
