#include "cli/morph_level_set.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <utility>

namespace isostack::cli {

namespace {

LevelSetMorphOptions with_choice(LevelSetMorphOptions options, const LevelSetMorphChoice& choice) {
  options.profile = choice.approach == "clamped" ? ApproachProfile::clamped
                    : choice.approach == "tanh"  ? ApproachProfile::tanh
                                                 : ApproachProfile::identity;
  options.pacing = choice.pace == "time"  ? FramePacing::time
                   : choice.pace == "rms" ? FramePacing::rms_distance
                                          : FramePacing::volume_fraction;
  options.transform = choice.transform == "rigid"                                ? TransformKind::rigid
                      : choice.transform == "affine"                             ? TransformKind::affine
                      : choice.transform == "warp" || !options.landmarks.empty() ? TransformKind::warp
                                                                                 : TransformKind::none;
  options.unshared = choice.missing_parts == "seed" ? UnsharedParts::seed : UnsharedParts::leave;
  options.width_pixels = choice.width_pixels;
  options.stop_rms_pixels = choice.stop_rms_pixels;
  return options;
}

std::string remark_on(const UnsharedPart& part, bool is_seeded) {
  const Eigen::Vector3d& p = part.place_mm;
  const std::string what = part.is_hollow ? fmt::format("{} fills a hollow of {} at {:.4g}, {:.4g}, {:.4g}", part.from,
                                                        part.to, p.x(), p.y(), p.z())
                                          : fmt::format("{} does not overlap the part of {} at {:.4g}, {:.4g}, {:.4g}",
                                                        part.from, part.to, p.x(), p.y(), p.z());
  return what + (is_seeded ? "; it grows from a seed" : "; it stays so (--missing-parts seed starts one there)");
}

void tell_unshared(const std::vector<UnsharedPart>& parts, bool is_seeded, Session& session) {
  session.result["unshared_parts"] = nlohmann::json::array();
  for (const UnsharedPart& part : parts) {
    session.note(remark_on(part, is_seeded));
    session.result["unshared_parts"].push_back({{"from", part.from},
                                                {"to", part.to},
                                                {"is_hollow", part.is_hollow},
                                                {"place_mm", {part.place_mm.x(), part.place_mm.y(), part.place_mm.z()}},
                                                {"content", part.content}});
  }
}

void tell_course(const LevelSetCourse& course, Session& session) {
  const LevelSetStep &first = course.steps.front(), &last = course.steps.back();
  session.result["courses"].push_back({{"from", course.from},
                                       {"to", course.to},
                                       {"steps", course.steps.size() - 1},
                                       {"arrived", course.arrived},
                                       {"shared_fraction", {first.shared_fraction, last.shared_fraction}},
                                       {"rms_mm", {first.rms_mm, last.rms_mm}},
                                       {"largest_mm", {first.largest_mm, last.largest_mm}}});
  session.text += fmt::format("{} to {}: {} steps, shares {:.1f} to {:.1f} %, ends {:.3g} mm (RMS) from it\n",
                              course.from, course.to, course.steps.size() - 1, 100 * first.shared_fraction,
                              100 * last.shared_fraction, last.rms_mm);
}

}  // namespace

bool LevelSetMorphChoice::is_default() const {
  const LevelSetMorphChoice none;
  return approach == none.approach && pace == none.pace && transform == none.transform &&
         missing_parts == none.missing_parts && width_pixels == none.width_pixels &&
         stop_rms_pixels == none.stop_rms_pixels;
}

void add_level_set_options(CLI::App& command, LevelSetMorphChoice& choice) {
  command
      .add_option("--approach", choice.approach,
                  "Level-set: speed by the distance to the target: identity (default), clamped or tanh")
      ->check(CLI::IsMember({"identity", "clamped", "tanh"}));
  command.add_option("--approach-width", choice.width_pixels, "Level-set: of clamped and tanh, pixels (4)")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--pace", choice.pace,
                  "Level-set: what goes evenly from frame to frame: volume (default), rms distance, or time")
      ->check(CLI::IsMember({"volume", "rms", "time"}));
  command
      .add_option("--transform", choice.transform,
                  "Level-set: moves a shape to the next besides: none (default), rigid, affine, by landmarks or else "
                  "moments, or warp, by landmarks")
      ->check(CLI::IsMember({"none", "rigid", "affine", "warp"}));
  command
      .add_option("--missing-parts", choice.missing_parts,
                  "Level-set: parts where the shape before has nothing: leave them (default), or seed them")
      ->check(CLI::IsMember({"leave", "seed"}));
  command.add_option("--stop-rms", choice.stop_rms_pixels, "Level-set: ends at this RMS distance, pixels (0.1)")
      ->check(CLI::PositiveNumber);
}

Morph morph_by_level_sets(const std::vector<KeyShape>& shapes, const LevelSetMorphChoice& choice,
                          LevelSetMorphOptions base, Session& session) {
  const LevelSetMorphOptions options = with_choice(std::move(base), choice);
  LevelSetPlan plan = plan_level_set_morph(shapes, options, session.progress());
  tell_unshared(plan.unshared, options.unshared == UnsharedParts::seed, session);
  LevelSetMorph result = run_level_set_morph(std::move(plan), session.progress());
  for (const LevelSetCourse& course : result.courses) tell_course(course, session);
  return std::move(result.morph);
}

}  // namespace isostack::cli
