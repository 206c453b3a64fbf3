#include "cli/morph_shapes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "cli/label_inputs.h"
#include "io/contours/contour_files.h"
#include "io/dicom/dicom_header.h"
#include "io/file_listing.h"
#include "io/formats.h"
#include "io/meshes/read_mesh.h"
#include "io/solid_file.h"
#include "recon/distance/distance_surface.h"
#include "recon/distance/solid.h"
#include "recon/geometry/errors.h"
#include "recon/reconstruct.h"

namespace isostack::cli {

namespace {

bool is_mesh(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path) || !find_format(path, &Format::read_mesh)) return false;
  return !find_format(path, &Format::read_contours) || !holds_contours(path);
}

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

/// Its surface on voxels of a hundredth of its longest side.
TriangleMesh surface_of(const CsgSolid& solid, Session& session) {
  const double voxel_mm = box_of(solid).sizes().maxCoeff() / 100;
  const Grid grid = distance_grid(solid, voxel_mm, 3 * voxel_mm);
  return distance_surface(solid_distance(solid, grid, {}, session.progress()).distance_mm, {}, session.progress());
}

KeyShape read_key_shape(InputOptions options, Session& session) {
  const std::filesystem::path path = options.paths.front();
  require_exists(path);
  KeyShape shape{.name = path.filename().string(), .shape = {}};
  session.progress().report("read", 0);
  if (holds_solid(path)) {
    shape.shape = surface_of(read_solid(path), session);
    return shape;
  }
  if (is_mesh(path)) {
    shape.shape = read_mesh(path);
    return shape;
  }
  if (!is_contours(path) && options.label.empty()) {
    const SliceStack stack = chosen_slices(read_images(options, session), options);
    if (!has_rule(options)) options.level = middle_level(stack, path).value_or("");
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

std::vector<KeyShape> read_key_shapes(const InputOptions& options, Session& session) {
  std::vector<KeyShape> shapes;
  for (const std::filesystem::path& path : options.paths) {
    InputOptions one = options;
    one.paths = {path};
    if (one.spacing_mm.empty()) one.spacing_mm = {1, 1, 1};
    shapes.push_back(read_key_shape(one, session));
  }
  return shapes;
}

}  // namespace isostack::cli
