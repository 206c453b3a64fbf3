#include "cli/retriangulation.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

namespace isostack::cli {

void add_retriangulation_options(CLI::App& command, RetriangulationOptions& options) {
  CLI::Option* edge_length = command
                                 .add_option("--edge-length", options.edge_length_mm,
                                             "Remesh the surface in even triangles with edges of this length, mm")
                                 ->check(CLI::PositiveNumber)
                                 ->type_name("MM");
  command
      .add_option("--simplify", options.simplify_tolerance_mm,
                  "Use as few triangles as stay within this distance of the full surface, mm")
      ->check(CLI::PositiveNumber)
      ->type_name("MM")
      ->excludes(edge_length);
  command
      .add_option("--triangles", options.triangles,
                  "Simplify to this many triangles; with --simplify, no farther than its distance allows")
      ->check(CLI::Range(4, 1'000'000'000))
      ->type_name("N")
      ->excludes(edge_length);
}

nlohmann::json to_json(const std::optional<RetriangulationReport>& report) {
  if (!report) return nullptr;
  const MeshQuality& quality = report->quality;
  return {{"triangles_before", report->triangles_before},
          {"triangles_after", report->triangles_after},
          {"mean_distance_mm", report->mean_distance_mm},
          {"largest_distance_mm", report->largest_distance_mm},
          {"vertices_off_surface", report->vertices_off_surface},
          {"edge_mm",
           {{"shortest", quality.shortest_edge_mm},
            {"p5", quality.edge_percentile5_mm},
            {"median", quality.median_edge_mm},
            {"p95", quality.edge_percentile95_mm},
            {"longest", quality.longest_edge_mm}}},
          {"smallest_angle_deg", quality.smallest_angle_deg},
          {"mean_smallest_angle_deg", quality.mean_smallest_angle_deg},
          {"seconds", report->seconds}};
}

std::string to_text(const std::optional<RetriangulationReport>& report) {
  if (!report) return {};
  const MeshQuality& quality = report->quality;
  return fmt::format(
      "  retriangulated  {} triangles from {}, {:.3f} mm mean, {:.3f} mm largest from the full surface, in {:.1f} s\n"
      "                  edges {:.3g} to {:.3g} mm (5 to 95 %, median {:.3g}), smallest angle {:.1f} degrees\n",
      report->triangles_after, report->triangles_before, report->mean_distance_mm, report->largest_distance_mm,
      report->seconds, quality.edge_percentile5_mm, quality.edge_percentile95_mm, quality.median_edge_mm,
      quality.smallest_angle_deg);
}

}  // namespace isostack::cli
