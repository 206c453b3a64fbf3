#include "cli/morph_blend.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "recon/geometry/errors.h"
#include "recon/morphing/frame_components.h"

namespace isostack::cli {

namespace {

TimeSpan span_of(const std::vector<double>& numbers) { return {.from = numbers[0], .to = numbers[1]}; }

BlendParameters parameters_of(const std::vector<double>& numbers) {
  return {.a0 = numbers[0], .a1 = numbers[1], .a2 = numbers[2], .a3 = numbers[3]};
}

/// Half of the coordinates are where the point is, half where it goes.
KeyDeformation pull_of(const BlendMorphChoice& choice) {
  const auto count = static_cast<Eigen::Index>(choice.pulled.size());
  if (count != 4 && count != 6)
    throw InputError("--pull", fmt::format("{} coordinates", count),
                     "give a point and where it goes: four coordinates for figures, six for bodies");
  const Eigen::Map<const Eigen::VectorXd> both(choice.pulled.data(), count);
  KeyDeformation pull{
      .key = 0, .from_mm = both.head(count / 2), .to_mm = both.tail(count / 2), .radius_mm = choice.pull_radius_mm};
  if (!choice.pulled_during.empty()) pull.during = span_of(choice.pulled_during);
  return pull;
}

}  // namespace

bool BlendMorphChoice::is_default() const {
  return ends == "smoothed" && slab.empty() && gap.empty() && blend.empty() && smoothing.empty() && pulled.empty() &&
         pulled_during.empty() && pull_radius_mm == 0 && length_mm == 0;
}

void add_blend_options(CLI::App& command, BlendMorphChoice& choice) {
  const auto add_numbers = [&](const std::string& name, std::vector<double>& into, int count, const char* type,
                               const std::string& about) {
    command.add_option(name, into, about)->delimiter(',')->expected(count)->type_name(type);
  };
  command
      .add_option("--ends", choice.ends, "Blend: half-cylinders end smoothed (default), or flat, with a jump between")
      ->check(CLI::IsMember({"smoothed", "flat"}));
  add_numbers("--slab", choice.slab, 2, "FROM,TO", "Blend: where between two shapes it happens (0,1)");
  add_numbers("--gap", choice.gap, 2, "FROM,TO", "Blend: between the half-cylinders (a 41st, in the slab's middle)");
  add_numbers("--blend", choice.blend, 4, "A0,A1,A2,A3",
              "Blend: a0 in mm and the rest (default: a0 so that no frame is empty, 2, 2, 1)");
  add_numbers("--smoothing-blend", choice.smoothing, 4, "A0,A1,A2,A3",
              "Blend: of the ends (default: the inradius, 0.7, 0.7, 1)");
  command.add_option("--length", choice.length_mm, "Blend: from one shape to the next in space-time, mm")
      ->check(CLI::PositiveNumber)
      ->type_name("MM");
  command
      .add_option("--pull", choice.pulled,
                  "Blend: a point of the first shape, and where it is pulled to (slice or LPS mm)")
      ->delimiter(',')
      ->expected(4, 6)
      ->type_name("FROM,TO");
  add_numbers("--pull-during", choice.pulled_during, 2, "FROM,TO", "Blend: when (0,0.4)");
  command.add_option("--pull-radius", choice.pull_radius_mm, "Blend: surroundings that come along (twice the way)")
      ->check(CLI::PositiveNumber)
      ->type_name("MM");
}

BlendMorphOptions blend_options(const BlendMorphChoice& choice, double resolution_mm) {
  BlendMorphOptions options;
  if (choice.ends == "flat") options.ends = HalfCylinderEnds::flat;
  if (!choice.slab.empty()) options.slab = span_of(choice.slab);
  if (!choice.gap.empty()) options.gap = span_of(choice.gap);
  if (choice.length_mm > 0) options.length_mm = choice.length_mm;
  if (!choice.blend.empty()) options.blend = parameters_of(choice.blend);
  if (!choice.smoothing.empty()) options.smoothing = parameters_of(choice.smoothing);
  if (!choice.pulled.empty()) options.deformations.push_back(pull_of(choice));
  options.resolution_mm = resolution_mm;
  return options;
}

void report_stray(const std::vector<MorphFrame>& frames, const std::vector<KeyShape>& shapes, Session& session) {
  std::vector<Shape> drawn;
  for (const MorphFrame& frame : frames) drawn.push_back(frame.shape);
  const FrameComponents components = frame_components(drawn, shapes);
  std::vector<std::string> stray;
  for (const std::size_t i : components.stray)
    stray.push_back(fmt::format("{} ({})", frames[i].name, components.counts[i]));
  session.result["most_given_components"] = components.most_given;
  session.result["stray_frames"] = stray;
  if (!stray.empty())
    session.note(
        fmt::format("frames fall into more pieces than the shapes' {}: {}; a larger a0 of --blend joins them, "
                    "--pull brings the shapes nearer",
                    components.most_given, fmt::join(stray, ", ")));
}

}  // namespace isostack::cli
