#include "cli/json_report.h"

#include <fmt/format.h>

#include "cli/alignment.h"
#include "cli/retriangulation.h"
#include "segmentation/trace_contours.h"

namespace isostack::cli {

namespace {

nlohmann::json to_json(const std::vector<SolveStage>& stages) {
  nlohmann::json list = nlohmann::json::array();
  for (const SolveStage& stage : stages)
    list.push_back({{"name", stage.name}, {"seconds", stage.seconds}, {"bytes", stage.bytes}});
  return list;
}

}  // namespace

nlohmann::json to_json(const ReconstructReport& report) {
  return {{"contour_points", report.contour_points},
          {"boundary_constraints", report.boundary_constraints},
          {"constraints", report.constraints},
          {"merged_constraints", report.merged_constraints},
          {"largest_contradiction_mm", report.largest_contradiction},
          {"contradictions", to_json(report.contradictions)},
          {"softened_constraints", report.softened_constraints},
          {"predicted_bytes", report.predicted_bytes},
          {"peak_bytes", report.peak_bytes},
          {"solver", report.solver},
          {"solves", report.solves},
          {"iterations", report.iterations},
          {"sweeps", report.sweeps},
          {"tolerance_mm", report.tolerance},
          {"largest_residual_mm", report.largest_residual},
          {"converged", report.converged},
          {"residual_remark", report.residual_remark},
          {"solve_stages", to_json(report.solve_stages)},
          {"resolution_mm", report.resolution_mm},
          {"contour_points_without_surface", report.contour_points_without_surface},
          {"plane_check",
           {{"points", report.plane_points},
            {"wrong", report.plane_points_wrong},
            {"wrong_between_slices", report.between_points_wrong},
            {"constraints_added", report.plane_constraints}}},
          {"contour_residual_mm",
           {{"mean", report.contour_residual.mean_mm},
            {"p95", report.contour_residual.percentile95_mm},
            {"largest", report.contour_residual.largest_mm}}},
          {"sections", to_json(report.sections)},
          {"section_constraints", report.section_constraints},
          {"smoothing", report.smoothing},
          {"retriangulation", to_json(report.retriangulation)},
          {"shares_faces_with", report.shares_faces_with},
          {"open_end", report.open_end},
          {"cut_by_bounds", report.cut_by_bounds},
          {"seconds",
           {{"constraints", report.constraint_seconds},
            {"solve", report.solve_seconds},
            {"surface", report.surface_seconds}}}};
}

nlohmann::json to_json(const SliceAgreement& agreement) {
  nlohmann::json result = {{"dice", agreement.dice},
                           {"slices", agreement.slices},
                           {"one_sided_slices", agreement.one_sided},
                           {"missed_contours", agreement.missed},
                           {"mean_distance_mm", nullptr},
                           {"percentile95_distance_mm", nullptr},
                           {"largest_distance_mm", nullptr}};
  if (!agreement.has_distances) return result;
  result["mean_distance_mm"] = agreement.mean_mm;
  result["percentile95_distance_mm"] = agreement.percentile95_mm;
  result["largest_distance_mm"] = agreement.largest_mm;
  return result;
}

nlohmann::json to_json(const MeshMeasures& measures) {
  return {{"volume_mm3", measures.volume_mm3},
          {"area_mm2", measures.area_mm2},
          {"vertices", measures.vertices},
          {"triangles", measures.triangles},
          {"components", measures.components},
          {"euler_characteristic", measures.euler_characteristic},
          {"genus", measures.watertight() ? nlohmann::json(measures.genus) : nlohmann::json(nullptr)},
          {"watertight", measures.watertight()},
          {"boundary_edges", measures.boundary_edges},
          {"non_manifold_edges", measures.non_manifold_edges},
          {"flipped_edges", measures.flipped_edges}};
}

nlohmann::json to_json(const ContourStack& organ) {
  std::size_t slices_with_contour = 0, contours = 0;
  nlohmann::json areas = nlohmann::json::array(), cut = nlohmann::json::array();
  for (const ContourSlice& slice : organ.slices) {
    slices_with_contour += slice.contours.empty() ? 0 : 1;
    contours += slice.contours.size();
    double area_mm2 = 0;
    for (const Contour& contour : slice.contours) area_mm2 += signed_area_mm2(contour);
    areas.push_back(area_mm2);
    if (touches_border(slice)) cut.push_back(&slice - organ.slices.data());
  }
  return {{"name", organ.name},         {"slices", organ.slices.size()}, {"slices_with_contour", slices_with_contour},
          {"contours", contours},       {"points", point_count(organ)},  {"area_mm2", areas},
          {"cut_by_field_of_view", cut}};
}

std::string to_text(const MeshMeasures& measures) {
  return fmt::format(
      "  volume      {:.3f} cm3\n  area        {:.2f} cm2\n  components  {}\n  genus       {}\n  closed      {}\n"
      "  triangles   {}\n",
      measures.volume_mm3 / 1000, measures.area_mm2 / 100, measures.components,
      measures.watertight() ? fmt::format("{}", measures.genus) : "undefined (not closed)",
      measures.watertight() ? "yes"
                            : fmt::format("no ({} open, {} non-manifold, {} flipped edges)", measures.boundary_edges,
                                          measures.non_manifold_edges, measures.flipped_edges),
      measures.triangles);
}

}  // namespace isostack::cli
