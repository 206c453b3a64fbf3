#include "cli/morph_subdivision.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <numbers>
#include <utility>

#include "cli/features_file.h"
#include "cli/morph_shapes.h"
#include "cli/path_roles.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

std::vector<TopologicalKeyShape> key_shapes_of(const SubdivisionMorphChoice& choice, InputOptions input,
                                               const BodyOptions& bodies, Session& session) {
  if (choice.key_shapes.empty()) return {};
  const std::size_t count = choice.key_shapes.size();
  if (!choice.key_shape_times.empty() && choice.key_shape_times.size() != count)
    throw InputError("--key-shape-at", fmt::format("{} times for {} key shapes", choice.key_shape_times.size(), count),
                     "give one for each --key-shape, in their order");
  input.paths = choice.key_shapes;
  std::vector<TopologicalKeyShape> result;
  for (KeyShape& shape : read_key_shapes(input, bodies, session)) {
    const std::size_t i = result.size();
    const double evenly = static_cast<double>(i + 1) / static_cast<double>(count + 1);
    result.push_back({.name = shape.name,
                      .shape = std::move(shape.shape),
                      .t = choice.key_shape_times.empty() ? evenly : choice.key_shape_times[i]});
  }
  return result;
}

TimeWarp sweep_of(const SubdivisionMorphChoice& choice, int dimension) {
  if (static_cast<int>(choice.sweep.size()) != dimension)
    throw InputError("--sweep", fmt::format("{} coordinates", choice.sweep.size()),
                     "give two for figures, three for bodies");
  const Eigen::VectorXd direction =
      Eigen::Map<const Eigen::VectorXd>(choice.sweep.data(), static_cast<Eigen::Index>(choice.sweep.size()));
  if (!(direction.norm() > 0)) throw InputError("--sweep", "a direction without length", "let it point somewhere");
  return sweep(direction, choice.sweep_lag);
}

}  // namespace

bool SubdivisionMorphChoice::is_default() const {
  return features.empty() && key_shapes.empty() && key_shape_times.empty() && sharp_angle_degrees == 0 && levels == 4 &&
         gamma == 4 && smoothing_passes == 16 && details == "fade" && sweep.empty() && sweep_lag == 0.8;
}

void add_subdivision_options(CLI::App& command, SubdivisionMorphChoice& choice) {
  command.add_option("--features", choice.features, "Subdivision: points that become one another, and more (JSON)")
      ->check(read_path())
      ->check(read_path())
      ->type_name("FILE");
  command
      .add_option("--key-shape", choice.key_shapes,
                  "Subdivision: a figure whose curves touch where parts join or split; may be repeated")
      ->check(read_path())
      ->check(read_path())
      ->allow_extra_args(false)
      ->type_name("FILE");
  command
      .add_option("--key-shape-at", choice.key_shape_times,
                  "Subdivision: when, between 0 and 1, one for each --key-shape (default: evenly)")
      ->allow_extra_args(false)
      ->type_name("T");
  command
      .add_option("--sharp-angle", choice.sharp_angle_degrees,
                  "Subdivision: corners that turn more stay sharp, the others are rounded (default: none is)")
      ->check(CLI::Range(1.0, 180.0))
      ->type_name("DEG");
  command.add_option("--levels", choice.levels, "Subdivision: how often the base is subdivided")
      ->check(CLI::Range(1, 8))
      ->capture_default_str();
  command.add_option("--gamma", choice.gamma, "Subdivision: weight of each level to the former: below 1 smooths less")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--smoothing-passes", choice.smoothing_passes, "Subdivision: of the filter at each level")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  command
      .add_option("--details", choice.details,
                  "Subdivision: details of the shapes fade (default), or linger on top of the smooth blend")
      ->check(CLI::IsMember({"fade", "linger"}));
  command
      .add_option("--sweep", choice.sweep,
                  "Subdivision: what lies first along this direction changes first (slice or LPS)")
      ->delimiter(',')
      ->expected(2, 3)
      ->type_name("X,Y[,Z]");
  command.add_option("--sweep-lag", choice.sweep_lag, "Subdivision: how far the last is behind, up to 1")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
}

SubdivisionMorphOptions subdivision_options(const SubdivisionMorphChoice& choice, const std::vector<KeyShape>& shapes,
                                            const InputOptions& input, const BodyOptions& bodies, Session& session) {
  SubdivisionMorphOptions options;
  options.levels = choice.levels;
  options.gamma = choice.gamma;
  options.smoothing_passes = choice.smoothing_passes;
  if (choice.details == "linger") options.details = DetailsBetween::linger;
  if (choice.sharp_angle_degrees > 0) options.sharp_angle_rad = choice.sharp_angle_degrees * std::numbers::pi / 180;
  if (!choice.features.empty()) {
    FeaturesFile file = read_features(choice.features, shapes);
    options.features = std::move(file.features);
    options.transitions = std::move(file.transitions);
    options.warp = std::move(file.warp);
  }
  if (!choice.sweep.empty()) options.warp = sweep_of(choice, dimension_of(shapes.front().shape));
  options.key_shapes = key_shapes_of(choice, input, bodies, session);
  return options;
}

void report_levels(const MorphReport& report, Session& session) {
  session.result["levels"] = nlohmann::json::array();
  session.text += " level  vertices        energy at first, then      off by, mm  iterations\n";
  for (const FitLevelReport& level : report.levels) {
    session.text += fmt::format("{:6}  {:8}  {:12.5g}  {:12.5g}  {:10.3g}  {:10}\n", session.result["levels"].size(),
                                level.vertices, level.first_energy, level.energy, level.residual_mm, level.iterations);
    session.result["levels"].push_back({{"vertices", level.vertices},
                                        {"first_energy", level.first_energy},
                                        {"energy", level.energy},
                                        {"first_residual_mm", level.first_residual_mm},
                                        {"residual_mm", level.residual_mm},
                                        {"iterations", level.iterations},
                                        {"converged", level.converged}});
  }
}

}  // namespace isostack::cli
