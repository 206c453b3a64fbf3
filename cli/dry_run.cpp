#include "cli/dry_run.h"

#include <fmt/format.h>

namespace isostack::cli {

namespace {

double megabytes(std::size_t bytes) { return static_cast<double>(bytes) / 1e6; }

nlohmann::json to_json(const OrganPrediction& organ) {
  return {{"name", organ.name},
          {"contours", organ.contours},
          {"contour_points", organ.contour_points},
          {"boundary_constraints", organ.boundary_constraints},
          {"constraints", organ.constraints},
          {"most_constraints", organ.most_constraints},
          {"resolution_mm", organ.resolution_mm},
          {"cells", organ.cells},
          {"solver", organ.solver},
          {"predicted_bytes", organ.solver_bytes},
          {"predicted_solve_bytes", organ.solve_bytes},
          {"predicted_surface_bytes", organ.surface_bytes}};
}

}  // namespace

void describe(const MemoryPrediction& prediction, Session& session) {
  for (const OrganPrediction& organ : prediction.organs) {
    session.result["predictions"].push_back(to_json(organ));
    session.text += fmt::format(
        "{}: {} contours with {} points, {} of them constraints\n"
        "  constraints {} at first, about {} at most; {} solver, {:.0f} MB\n"
        "  surface     about {} cells of {:.3g} mm\n",
        organ.name, organ.contours, organ.contour_points, organ.boundary_constraints, organ.constraints,
        organ.most_constraints, organ.solver, megabytes(organ.solver_bytes), organ.cells, organ.resolution_mm);
  }
  session.result["predicted_process_bytes"] = prediction.process_bytes;
  session.text += fmt::format("memory of the whole program: {:.0f} MB at most\n", megabytes(prediction.process_bytes));
}

}  // namespace isostack::cli
