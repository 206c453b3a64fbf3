#include "cli/morph_shapes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "cli/label_inputs.h"
#include "cli/segment_images.h"
#include "io/contours/contour_files.h"
#include "io/dicom/dicom_header.h"
#include "io/file_listing.h"
#include "io/formats.h"
#include "recon/distance/distance_surface.h"
#include "recon/geometry/errors.h"
#include "recon/reconstruct.h"

namespace isostack::cli {

namespace {

bool has_rule(const InputOptions& options) {
  return !options.level.empty() || !options.label.empty() || options.organ.has_rule();
}

bool is_contours(const std::filesystem::path& path) { return is_contour_file(path) || holds_named_organs(path); }

/// The middle of the grey range of a lone picture, as --level; nothing for stacks.
std::optional<std::string> middle_level(const SliceStack& stack, const std::filesystem::path& path) {
  if (stack.slices.size() != 1) return std::nullopt;
  const Image<float>& pixels = stack.slices.front().pixels;
  const float low = pixels.minCoeff(), high = pixels.maxCoeff();
  if (!(low < high))
    throw InputError(path.string(), fmt::format("every pixel has the value {:g}, so that it shows no shape", low),
                     "give a picture with the shape in another grey than its ground");
  return fmt::format("{}", (static_cast<double>(low) + high) / 2);
}

/// What the picture's grey values say, for the recipe that works on them; nothing when they were filtered first.
std::optional<GreyFigure> grey_figure(const InputOptions& options, const SliceStack& stack) {
  const bool only_level = !options.level.empty() && !options.organ.has_rule() &&
                          !(options.segmentation.gaussian_sigma_pixels > 0) && !(options.segmentation.curvature > 0) &&
                          !options.segmentation.fill_holes && !options.segmentation.largest;
  if (stack.slices.size() != 1 || !only_level) return std::nullopt;
  const double sign = options.darker ? -1 : 1;
  return GreyFigure{.pixels = static_cast<float>(sign) * stack.slices.front().pixels,
                    .level = sign * level_of(options)};
}

std::string names_of(const std::vector<ContourStack>& organs) {
  std::vector<std::string> names;
  for (const ContourStack& organ : organs) names.push_back(organ.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// One slice: a figure. Several: the body through them.
Shape shape_of(const ContourStack& organ, const std::string& where, Session& session) {
  if (organ.slices.size() != 1) return reconstruct(organ, {}, session.progress()).surface;
  if (point_count(organ) == 0)
    throw InputError(where, "its slice shows no contour of the shape", "give a slice or a level that shows it");
  return organ.slices.front();
}

KeyShape read_key_shape(InputOptions options, const BodyOptions& bodies, Session& session) {
  const std::filesystem::path path = options.paths.front();
  require_exists(path);
  KeyShape shape{.name = path.filename().string(), .shape = {}};
  session.progress().report("read", 0);
  if (std::optional<TriangleMesh> body = read_body(path, bodies, session)) {
    shape.shape = std::move(*body);
    return shape;
  }
  if (!is_contours(path) && options.label.empty()) {
    const SliceStack stack = chosen_slices(read_images(options, session), options);
    if (!has_rule(options)) options.level = middle_level(stack, path).value_or("");
    if (options.organ.in_volume && stack.slices.size() > 1) {
      shape.shape =
          distance_surface(distances_in_images(stack, options, path.string(), session), {}, session.progress());
      return shape;
    }
    shape.image = grey_figure(options, stack);
  }
  const std::vector<ContourStack> organs = drawn_organs_from(options, session);
  if (organs.size() != 1)
    throw InputError(path.string(), "it holds several shapes (" + names_of(organs) + ")",
                     "choose one with --organ or --label");
  shape.shape = shape_of(organs.front(), path.string(), session);
  return shape;
}

}  // namespace

std::vector<KeyShape> read_key_shapes(const InputOptions& options, const BodyOptions& bodies, Session& session) {
  std::vector<KeyShape> shapes;
  for (const std::filesystem::path& path : options.paths) {
    InputOptions one = options;
    one.paths = {path};
    if (one.spacing_mm.empty()) one.spacing_mm = {1, 1, 1};
    shapes.push_back(read_key_shape(one, bodies, session));
  }
  return shapes;
}

}  // namespace isostack::cli
