#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.h"
#include "cli/path_roles.h"
#include "io/inspect.h"

namespace isostack::cli {

namespace {

nlohmann::json to_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
nlohmann::json to_json(const Eigen::Vector2d& v) { return {v.x(), v.y()}; }

nlohmann::json image_json(const SeriesSummary& s) {
  nlohmann::json entry = {{"slices", s.slice_count},
                          {"columns", s.columns},
                          {"rows", s.rows},
                          {"smallest_spacing_mm", to_json(s.smallest_spacing_mm)},
                          {"largest_spacing_mm", to_json(s.largest_spacing_mm)},
                          {"row_direction", to_json(s.row_direction)},
                          {"column_direction", to_json(s.column_direction)},
                          {"orientation", s.orientation},
                          {"orientations", s.orientation_count},
                          {"tilt_deg", s.tilt_deg},
                          {"extent_mm", to_json(s.extent_mm)},
                          {"phases", s.phase_count},
                          {"value_type", s.value_type}};
  if (!s.phases_by.empty()) entry["phases_by"] = s.phases_by;
  if (s.slice_thickness_mm) entry["slice_thickness_mm"] = *s.slice_thickness_mm;
  for (const OrientationSummary& o : s.orientations)
    entry["directions"].push_back(
        {{"orientation", o.letters}, {"slices", o.slice_count}, {"normal", to_json(o.normal)}});
  if (s.gaps)
    entry["gaps_mm"] = {
        {"smallest", s.gaps->smallest_mm}, {"median", s.gaps->median_mm}, {"largest", s.gaps->largest_mm}};
  return entry;
}

nlohmann::json to_json(const OrganSummary& organ) {
  nlohmann::json entry = {{"name", organ.name}, {"type", organ.type}, {"color", nullptr}};
  if (organ.number > 0) {
    entry.update({{"number", organ.number}, {"frames", organ.frame_count}, {"voxels", nullptr}});
    if (organ.voxel_count) entry["voxels"] = *organ.voxel_count;
  } else {
    entry.update({{"slices", organ.slice_count}, {"contours", organ.contour_count}, {"points", organ.point_count}});
  }
  if (organ.color) entry["color"] = {organ.color->red, organ.color->green, organ.color->blue};
  return entry;
}

std::string to_text(const OrganSummary& organ) {
  const std::string color =
      organ.color ? fmt::format("#{:02x}{:02x}{:02x}", organ.color->red, organ.color->green, organ.color->blue) : "";
  if (organ.number > 0)
    return fmt::format("   segment {:<4} {:<24} {:<12} {:<7} {} frames{}\n", organ.number, organ.name, organ.type,
                       color, organ.frame_count,
                       organ.voxel_count ? fmt::format(", {} voxels", *organ.voxel_count) : std::string());
  return fmt::format("   ROI          {:<24} {:<12} {:<7} {} contours on {} slices, {} points\n", organ.name,
                     organ.type, color, organ.contour_count, organ.slice_count, organ.point_count);
}

nlohmann::json to_json(const SeriesSummary& s) {
  nlohmann::json entry = {{"number", s.number},     {"kind", s.kind},         {"name", s.name},
                          {"modality", s.modality}, {"encoding", s.encoding}, {"series_uid", s.series_uid},
                          {"warnings", s.warnings}};
  if (s.slice_count > 0) entry.update(image_json(s));
  if (s.vertex_count > 0) entry.update({{"vertices", s.vertex_count}, {"triangles", s.triangle_count}});
  if (s.contour_count > 0) entry.update({{"contours", s.contour_count}, {"points", s.point_count}});
  for (const OrganSummary& organ : s.organs) entry["organs"].push_back(to_json(organ));
  if (s.vertex_count > 0 || s.contour_count > 0)
    entry.update({{"lower_mm", to_json(s.lower_mm)}, {"upper_mm", to_json(s.upper_mm)}});
  return entry;
}

std::string slices_text(const SeriesSummary& s) {
  if (s.orientation.empty()) return fmt::format("   files        {}\n", s.slice_count);  // not placed in space
  std::string text = fmt::format("   slices       {} of {} x {}, pixels {:.4g} x {:.4g} mm{}\n", s.slice_count,
                                 s.columns, s.rows, s.smallest_spacing_mm.x(), s.smallest_spacing_mm.y(),
                                 s.slice_thickness_mm ? fmt::format(", {:.4g} mm thick", *s.slice_thickness_mm) : "");
  if (s.phase_count > 1) text += fmt::format("   phases       {} by {}\n", s.phase_count, s.phases_by);
  if (s.gaps)
    text += fmt::format("   gaps         {:.3f} to {:.3f} mm, median {:.3f}\n", s.gaps->smallest_mm, s.gaps->largest_mm,
                        s.gaps->median_mm);
  if (s.orientations.size() > 1) {
    for (const OrientationSummary& o : s.orientations)
      text += fmt::format("   direction    {}, {} slices, normal ({:.3f}, {:.3f}, {:.3f})\n", o.letters, o.slice_count,
                          o.normal.x(), o.normal.y(), o.normal.z());
    return text;
  }
  return text + fmt::format("   orientation  {}, tilt {:.1f} degrees, extent {:.1f} x {:.1f} x {:.1f} mm\n",
                            s.orientation, s.tilt_deg, s.extent_mm.x(), s.extent_mm.y(), s.extent_mm.z());
}

std::string to_text(const SeriesSummary& s) {
  std::string text = s.number > 0 ? fmt::format("{}. ", s.number) : "";
  text += s.kind + (s.modality.empty() ? "" : " " + s.modality) + (s.name.empty() ? "" : " " + s.name) + "\n";
  if (!s.series_uid.empty()) text += fmt::format("   series       {}\n", s.series_uid);
  if (!s.encoding.empty())
    text += fmt::format("   encoding     {}{}\n", s.encoding, s.value_type.empty() ? "" : ", " + s.value_type);
  if (s.slice_count > 0) text += slices_text(s);
  if (s.vertex_count > 0)
    text += fmt::format("   surface      {} vertices, {} triangles\n", s.vertex_count, s.triangle_count);
  if (s.contour_count > 0) text += fmt::format("   contours     {} with {} points\n", s.contour_count, s.point_count);
  for (const OrganSummary& organ : s.organs) text += to_text(organ);
  if (s.vertex_count > 0 || s.contour_count > 0)
    text += fmt::format("   bounds       ({:.1f}, {:.1f}, {:.1f}) to ({:.1f}, {:.1f}, {:.1f}) mm LPS\n", s.lower_mm.x(),
                        s.lower_mm.y(), s.lower_mm.z(), s.upper_mm.x(), s.upper_mm.y(), s.upper_mm.z());
  for (const std::string& warning : s.warnings) text += "   warning: " + warning + "\n";
  return text;
}

void run_info(const std::vector<std::filesystem::path>& paths, Session& session) {
  for (const std::filesystem::path& path : paths) {
    nlohmann::json& entry = session.result["inputs"].emplace_back();
    entry["path"] = path.string();
    session.text += path.string() + "\n";
    for (const SeriesSummary& series : inspect(path)) {
      entry["series"].push_back(to_json(series));
      session.text += to_text(series);
    }
  }
}

}  // namespace

void add_info(CLI::App& app, Session& session) {
  auto paths = std::make_shared<std::vector<std::filesystem::path>>();
  CLI::App* command = app.add_subcommand("info", "What is there: series, geometry, spacing, problems");
  command->add_option("PATH", *paths, "Folders and files")->check(read_path())->required();
  command->callback([paths, &session] { session.run = [paths, &session] { run_info(*paths, session); }; });
}

}  // namespace isostack::cli
