#include "cli/leave_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "cli/json_report.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/leave_out.h"
#include "viewers/line_plot.h"

namespace isostack::cli {

namespace {

struct OrganStudy {
  std::string organ;
  LeaveOutStudy study;
};

nlohmann::json entry_of(const MethodAgreement& method) {
  nlohmann::json entry = to_json(method.agreement);
  entry["method"] = method.method;
  entry["seconds"] = method.seconds;
  return entry;
}

nlohmann::json to_json(const OrganStudy& organ) {
  nlohmann::json entry = {{"organ", organ.organ},
                          {"every", organ.study.every},
                          {"kept", organ.study.kept},
                          {"dropped", organ.study.dropped},
                          {"constraints", organ.study.report.constraints}};
  for (const MethodAgreement& method : organ.study.methods) entry["methods"].push_back(entry_of(method));
  return entry;
}

std::string table(const std::vector<OrganStudy>& studies) {
  std::size_t widest = 5;
  for (const OrganStudy& organ : studies) widest = std::max(widest, organ.organ.size());
  std::string text =
      fmt::format("{:{}}  every  kept  dropped  method      Dice   mean mm   95 % mm  largest mm\n", "organ", widest);
  for (const OrganStudy& organ : studies)
    for (const MethodAgreement& method : organ.study.methods) {
      const SliceAgreement& a = method.agreement;
      text += fmt::format("{:{}}  {:5}  {:4}  {:7}  {:8}  {:6.4f}  ", organ.organ, widest, organ.study.every,
                          organ.study.kept, organ.study.dropped, method.method, a.dice);
      text += a.has_distances ? fmt::format("{:8.3f}  {:8.3f}  {:10.3f}\n", a.mean_mm, a.percentile95_mm, a.largest_mm)
                              : fmt::format("{:>8}  {:>8}  {:>10}\n", "-", "-", "-");
    }
  return text;
}

/// One line per organ and method. With several organs the colour is the organ's and the dashes are the method's.
LinePlot plot_of(const std::vector<OrganStudy>& studies, const std::string& title, const std::string& y_label,
                 const std::function<double(const SliceAgreement&)>& value) {
  LinePlot plot{.title = title, .x_label = "every K-th slice kept", .y_label = y_label, .lines = {}, .x_ticks = {}};
  std::vector<std::string> organs;
  for (const OrganStudy& organ : studies) {
    if (std::find(organs.begin(), organs.end(), organ.organ) == organs.end()) organs.push_back(organ.organ);
    if (std::find(plot.x_ticks.begin(), plot.x_ticks.end(), organ.study.every) == plot.x_ticks.end())
      plot.x_ticks.push_back(organ.study.every);
  }
  std::sort(plot.x_ticks.begin(), plot.x_ticks.end());
  const bool several = organs.size() > 1;
  const std::vector<std::string> methods = {"isostack", "cubic", "linear"};
  for (std::size_t o = 0; o < organs.size(); ++o)
    for (std::size_t m = 0; m < methods.size(); ++m) {
      PlotLine line{.name = several ? organs[o] + ", " + methods[m] : methods[m],
                    .points = {},
                    .colour = static_cast<int>(several ? o : m),
                    .dashes = static_cast<int>(m)};
      for (const OrganStudy& organ : studies)
        for (const MethodAgreement& method : organ.study.methods)
          if (organ.organ == organs[o] && method.method == methods[m] && method.agreement.has_distances)
            line.points.emplace_back(organ.study.every, value(method.agreement));
      std::sort(line.points.begin(), line.points.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
      if (!line.points.empty()) plot.lines.push_back(std::move(line));
    }
  return plot;
}

void save_plot(const std::vector<OrganStudy>& studies, const std::filesystem::path& path, Session& session) {
  LinePlot distance = plot_of(studies, "Contour distance on dropped slices", "mean distance, mm",
                              [](const SliceAgreement& a) { return a.mean_mm; });
  distance.from_zero = true;
  const LinePlot dice =
      plot_of(studies, "Overlap on dropped slices", "Dice", [](const SliceAgreement& a) { return a.dice; });
  save_line_plots({distance, dice}, path);
  session.wrote(path);
}

/// An organ too small for what is kept is noted and left out; the others go on.
void study_organ(const ContourStack& organ, int every, const ReconstructOptions& options, Session& session,
                 std::vector<OrganStudy>& studies) {
  try {
    studies.push_back({organ.name, leave_out(organ, every, options, session.progress())});
  } catch (const GeometryError& error) {
    session.note(fmt::format("--leave-out {}: {}", every, error.what()));
    return;
  }
  session.result["leave_out"].push_back(to_json(studies.back()));
}

bool any_one_sided(const std::vector<OrganStudy>& studies) {
  for (const OrganStudy& organ : studies)
    for (const MethodAgreement& method : organ.study.methods)
      if (method.agreement.one_sided > 0) return true;
  return false;
}

}  // namespace

void run_leave_out(const LeaveOutCommand& command, const InputOptions& input, Session& session) {
  if (!command.plot.empty() && command.plot.extension() != ".svg")
    throw InputError(command.plot.string(), "plots are written as SVG only", "let the name end in .svg");
  const std::vector<ContourStack> organs = drawn_organs_from(input, session);
  std::vector<OrganStudy> studies;
  for (const ContourStack& organ : organs)
    for (const int every : command.every) study_organ(organ, every, command.options, session, studies);
  if (studies.empty())
    throw InputError("--leave-out", "no organ is left on two of the kept slices", "keep more slices with a smaller K");
  if (any_one_sided(studies))
    session.note("on some dropped slices only one side has contours (one_sided_slices): distances leave them out");
  session.text += table(studies);
  if (!command.plot.empty()) save_plot(studies, command.plot, session);
}

}  // namespace isostack::cli
