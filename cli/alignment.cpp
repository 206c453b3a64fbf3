#include "cli/alignment.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <numbers>

#include "cli/outputs.h"
#include "cli/path_roles.h"
#include "io/contours/contour_files.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

nlohmann::json as_json(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

double degrees(double rad) { return rad * 180 / std::numbers::pi; }

nlohmann::json to_json(const Alignment& alignment) {
  nlohmann::json slices = nlohmann::json::array();
  for (std::size_t s = 0; s < alignment.motions.size(); ++s) {
    const InPlaneMotion& motion = alignment.motions[s];
    slices.push_back({{"slice", alignment.stack.slices[s].name},
                      {"shift_mm", {motion.shift_mm.x(), motion.shift_mm.y()}},
                      {"rotation_deg", degrees(motion.rotation_rad)}});
  }
  return {{"name", alignment.stack.name},
          {"slices", std::move(slices)},
          {"iterations", alignment.iterations},
          {"before", cli::to_json(alignment.before)},
          {"after", cli::to_json(alignment.after)}};
}

void describe(const Alignment& alignment, const AlignOptions& options, Session& session) {
  session.result["alignments"].push_back(to_json(alignment));
  const std::string& name = alignment.stack.name;
  session.text += fmt::format("{}: slices contradicted each other on {:.1f} mm, after alignment on {:.1f} mm\n", name,
                              alignment.before.disagreement_mm(), alignment.after.disagreement_mm());
  for (std::size_t s = 0; s < alignment.motions.size(); ++s) {
    const InPlaneMotion& motion = alignment.motions[s];
    if (motion.shift_mm.norm() < 0.05 && std::abs(degrees(motion.rotation_rad)) < 0.1) continue;
    session.text += fmt::format("  moved {:24} {:6.2f} {:6.2f} mm {:6.2f} deg\n", alignment.stack.slices[s].name,
                                motion.shift_mm.x(), motion.shift_mm.y(), degrees(motion.rotation_rad));
    if (motion.shift_mm.norm() > 0.999 * options.max_shift_mm)
      session.note(fmt::format("{}: slice {} was moved as far as --align-limit allows; look at it", name,
                               alignment.stack.slices[s].name));
  }
}

}  // namespace

void add_alignment_options(CLI::App& command, AlignmentCommand& alignment) {
  auto* align = command.add_flag("--align", alignment.align,
                                 "Move slices in their planes until crossing slices contradict each other least");
  command.add_flag("--align-rotation", alignment.options.rotation, "Turn them, too")->needs(align);
  command.add_option("--align-limit", alignment.options.max_shift_mm, "No slice moves farther, mm")
      ->check(CLI::PositiveNumber)
      ->capture_default_str()
      ->needs(align);
  command.add_option("--aligned", alignment.aligned, "Write the moved contours (.vtp, .json)")
      ->check(written_path())
      ->type_name("FILE")
      ->needs(align);
}

std::vector<ContourStack> aligned(std::vector<ContourStack> organs, const AlignmentCommand& command, Session& session) {
  if (!command.align) return organs;
  if (!command.aligned.empty()) require_writable(command.aligned, OutputPurpose::kContoursOrLabels);
  if (!command.aligned.empty() && is_label_file(command.aligned))
    throw InputError("--aligned", "labels have no place of their own", "give a contour file, .vtp or .json");
  for (ContourStack& organ : organs) {
    Alignment alignment = align_slices(organ, command.options, session.progress());
    describe(alignment, command.options, session);
    organ = std::move(alignment.stack);
  }
  if (command.aligned.empty()) return organs;
  write_contours(organs, command.aligned);
  session.wrote(command.aligned);
  return organs;
}

nlohmann::json to_json(const Contradictions& contradictions) {
  nlohmann::json pairs = nlohmann::json::array();
  for (const SlicePair& pair : contradictions.pairs) {
    nlohmann::json places = nlohmann::json::array();
    for (const Contradiction& place : pair.places)
      places.push_back({{"from_mm", as_json(place.ends[0].point_mm)},
                        {"to_mm", as_json(place.ends[1].point_mm)},
                        {"length_mm", place.length_mm},
                        {"distance_mm", place.distance_mm}});
    pairs.push_back({{"slices", {pair.first_name, pair.second_name}},
                     {"indices", {pair.first, pair.second}},
                     {"line_mm", pair.line_mm},
                     {"disagreement_mm", pair.disagreement_mm},
                     {"largest_mismatch_mm", pair.largest_mismatch_mm},
                     {"places", std::move(places)}});
  }
  return {{"disagreement_mm", contradictions.disagreement_mm()},
          {"largest_mismatch_mm", contradictions.largest_mismatch_mm()},
          {"pairs", std::move(pairs)}};
}

std::string to_text(const Contradictions& contradictions, double least_mm) {
  std::vector<const SlicePair*> worst;
  for (const SlicePair& pair : contradictions.pairs)
    if (pair.largest_mismatch_mm >= least_mm) worst.push_back(&pair);
  if (worst.empty()) return {};
  std::stable_sort(worst.begin(), worst.end(), [](const SlicePair* a, const SlicePair* b) {
    return a->largest_mismatch_mm > b->largest_mismatch_mm;
  });
  std::string text = fmt::format("  {} of {} pairs of crossing slices contradict each other by {:.2g} mm or more:\n",
                                 worst.size(), contradictions.pairs.size(), least_mm);
  worst.resize(std::min<std::size_t>(worst.size(), 10));
  for (const SlicePair* pair : worst)
    text += fmt::format("    largest {:6.2f} mm, in all {:6.2f} of {:6.1f} mm: {} and {}\n", pair->largest_mismatch_mm,
                        pair->disagreement_mm, pair->line_mm, pair->first_name, pair->second_name);
  return text;
}

}  // namespace isostack::cli
