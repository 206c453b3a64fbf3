#include "viewers/line_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "io/atomic_file.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// P. Tol's "bright" scheme, which colour-blind eyes tell apart on white, and black.
constexpr std::array<std::string_view, 8> colours = {"#4477aa", "#ee6677", "#228833", "#aa3377",
                                                     "#ccbb44", "#66ccee", "#888888", "#000000"};
constexpr std::array<std::string_view, 4> dash_patterns = {"", "7 4", "2 3", "8 3 2 3"};
constexpr double character_pixels = 6.6;  ///< about, of the 12 pixel font

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else
      result += c;
  }
  return result;
}

std::size_t wrapped(int number, std::size_t count) { return static_cast<std::size_t>(std::max(number, 0)) % count; }

/// Where one plot's axes lie on the picture and what they show.
struct Axes {
  double left, right, top, bottom;  ///< pixels
  double x_low, x_high, y_low, y_high;
  double x(double value) const { return left + (value - x_low) / (x_high - x_low) * (right - left); }
  double y(double value) const { return bottom - (value - y_low) / (y_high - y_low) * (bottom - top); }
};

struct Range {
  double low = INFINITY, high = -INFINITY;
  void extend(double value) { low = std::min(low, value), high = std::max(high, value); }
};

struct Ranges {
  Range x, y;
};

Ranges ranges_of(const LinePlot& plot) {
  Ranges ranges;
  for (const PlotLine& line : plot.lines)
    for (const Eigen::Vector2d& p : line.points) {
      if (!p.allFinite())
        throw InputError("plot", "line '" + line.name + "' has a point that is not finite", "leave it out");
      ranges.x.extend(p.x());
      ranges.y.extend(p.y());
    }
  if (!(ranges.x.low <= ranges.x.high)) throw InputError("plot", "there is no point to draw", "give at least one");
  if (plot.from_zero) ranges.y.extend(0);
  return ranges;
}

double legend_width(const LinePlot& plot) {
  std::size_t longest = 0;
  for (const PlotLine& line : plot.lines) longest = std::max(longest, line.name.size());
  return 40 + character_pixels * static_cast<double>(longest);
}

std::string tick_text(double value) { return fmt::format("{:.6g}", std::abs(value) < 1e-12 ? 0.0 : value); }

std::string text_at(double x, double y, std::string_view anchor, const std::string& text, std::string_view more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x, y, anchor, more,
                     escaped(text));
}

std::string straight(double x1, double y1, double x2, double y2, std::string_view stroke) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x1, y1, x2, y2,
                     stroke);
}

std::string draw_axes(const LinePlot& plot, const Axes& axes, const std::vector<double>& x_ticks,
                      const std::vector<double>& y_ticks) {
  std::string svg;
  for (const double tick : y_ticks) {
    svg += straight(axes.left, axes.y(tick), axes.right, axes.y(tick), "#e4e4e4");
    svg += text_at(axes.left - 8, axes.y(tick) + 4, "end", tick_text(tick));
  }
  for (const double tick : x_ticks) {
    svg += straight(axes.x(tick), axes.bottom, axes.x(tick), axes.bottom + 5, "#333333");
    svg += text_at(axes.x(tick), axes.bottom + 19, "middle", tick_text(tick));
  }
  svg += straight(axes.left, axes.bottom, axes.right, axes.bottom, "#333333");
  svg += straight(axes.left, axes.top, axes.left, axes.bottom, "#333333");
  const double middle_x = (axes.left + axes.right) / 2, middle_y = (axes.top + axes.bottom) / 2;
  svg += text_at(middle_x, axes.bottom + 40, "middle", plot.x_label);
  svg += text_at(axes.left - 62, middle_y, "middle", plot.y_label,
                 fmt::format("transform=\"rotate(-90 {:.1f} {:.1f})\"", axes.left - 62, middle_y));
  svg += text_at(middle_x, axes.top - 16, "middle", plot.title, "font-size=\"14\" font-weight=\"bold\"");
  return svg;
}

std::string marker(double x, double y, std::size_t shape, std::string_view colour) {
  if (shape == 0) return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.6\" fill=\"{}\"/>\n", x, y, colour);
  if (shape == 1)
    return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"6.6\" height=\"6.6\" fill=\"{}\"/>\n", x - 3.3, y - 3.3,
                       colour);
  const double up = shape == 2 ? -4.4 : 4.4;
  return fmt::format("<polygon points=\"{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}\" fill=\"{}\"/>\n", x, y + up,
                     x - 4.2, y - 0.7 * up, x + 4.2, y - 0.7 * up, colour);
}

std::string draw_line(const std::vector<Eigen::Vector2d>& pixels, const PlotLine& line, std::size_t place) {
  const std::string_view colour =
      colours[line.colour < 0 ? place % colours.size() : wrapped(line.colour, colours.size())];
  const std::size_t dashes = wrapped(line.dashes, dash_patterns.size());
  std::string path, svg;
  for (const Eigen::Vector2d& p : pixels) path += fmt::format("{:.1f},{:.1f} ", p.x(), p.y());
  svg +=
      fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" stroke-dasharray=\"{}\"/>\n",
                  path, colour, dashes == 0 ? "none" : dash_patterns[dashes]);
  return svg;
}

std::string draw_markers(const std::vector<Eigen::Vector2d>& pixels, const PlotLine& line, std::size_t place) {
  std::string svg;
  for (const Eigen::Vector2d& p : pixels)
    svg += marker(p.x(), p.y(), wrapped(line.dashes, dash_patterns.size()),
                  colours[line.colour < 0 ? place % colours.size() : wrapped(line.colour, colours.size())]);
  return svg;
}

std::string draw_plot(const LinePlot& plot, double offset, const LinePlotOptions& options) {
  const Ranges ranges = ranges_of(plot);
  std::vector<double> x_ticks = plot.x_ticks.empty() ? round_ticks(ranges.x.low, ranges.x.high, 6) : plot.x_ticks;
  const std::vector<double> y_ticks = round_ticks(ranges.y.low, ranges.y.high, 6);
  const double x_low = std::min(ranges.x.low, x_ticks.front()), x_high = std::max(ranges.x.high, x_ticks.back());
  const double margin = x_high > x_low ? 0.04 * (x_high - x_low) : 1;
  const Axes axes{offset + 84,
                  offset + options.width_pixels - legend_width(plot) - 16,
                  42.0,
                  options.height_pixels - 54.0,
                  x_low - margin,
                  x_high + margin,
                  y_ticks.front(),
                  y_ticks.back()};
  std::string svg = draw_axes(plot, axes, x_ticks, y_ticks);
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    const PlotLine& line = plot.lines[i];
    std::vector<Eigen::Vector2d> pixels;
    for (const Eigen::Vector2d& p : line.points) pixels.emplace_back(axes.x(p.x()), axes.y(p.y()));
    svg += draw_line(pixels, line, i) + draw_markers(pixels, line, i);
    const double y = axes.top + 10 + 20 * static_cast<double>(i), x = axes.right + 12;
    svg += draw_line({{x, y}, {x + 26, y}}, line, i) + draw_markers({{x + 13, y}}, line, i);
    svg += text_at(x + 33, y + 4, "start", line.name);
  }
  return svg;
}

}  // namespace

std::vector<double> round_ticks(double low, double high, int about) {
  if (!(high - low > 1e-9 * std::max(std::abs(low), std::abs(high)))) {  // one value: a round step to either side
    const double half = low == 0 ? 1 : 0.1 * std::abs(low);
    low -= half, high += half;
  }
  const double least = (high - low) / std::max(about, 1);
  const double power = std::pow(10, std::floor(std::log10(least)));
  const double share = least / power;
  const double step = power * (share <= 1 ? 1 : share <= 2 ? 2 : share <= 5 ? 5 : 10);
  const double first = std::floor(low / step + 1e-9), last = std::ceil(high / step - 1e-9);
  std::vector<double> ticks;
  for (double n = first; n <= last; ++n) ticks.push_back(n * step);
  return ticks;
}

std::string line_plots_svg(const std::vector<LinePlot>& plots, const LinePlotOptions& options) {
  if (plots.empty()) throw InputError("plot", "there is nothing to draw", "give at least one plot");
  const int width = options.width_pixels * static_cast<int>(plots.size());
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\" fill=\"#222222\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      width, options.height_pixels);
  for (std::size_t i = 0; i < plots.size(); ++i)
    svg += draw_plot(plots[i], static_cast<double>(i) * options.width_pixels, options);
  return svg + "</svg>\n";
}

void save_line_plots(const std::vector<LinePlot>& plots, const std::filesystem::path& svg,
                     const LinePlotOptions& options) {
  if (svg.extension() != ".svg")
    throw InputError(svg.string(), "plots are written as SVG only", "let the name end in .svg");
  write_whole_file(svg, line_plots_svg(plots, options));
}

}  // namespace isostack
