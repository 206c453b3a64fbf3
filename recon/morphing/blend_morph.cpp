#include "recon/morphing/blend_morph.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "recon/functions/point_deformation.h"
#include "recon/functions/solids.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/pixel_lattice.h"
#include "recon/geometry/stopwatch.h"
#include "recon/morphing/blend_defaults.h"
#include "recon/morphing/blend_sections.h"

namespace isostack {

namespace {

constexpr double default_slab = 2.05;   // in longest sides of the box round all shapes
constexpr double default_radius = 2.0;  // of deformations, in ways

BoxedSolid boxed_solid(const KeyShape& shape, const SlicePose& pose) {
  BoxedSolid result{.solid = {}, .box_mm = box_of(shape.shape, pose), .dimension = dimension_of(shape.shape)};
  if (const auto* figure = std::get_if<ContourSlice>(&shape.shape))
    result.solid = figure_solid(moved_to(pose, figure->contours, figure->pose));
  else
    result.solid = mesh_solid(std::get<TriangleMesh>(shape.shape));
  return result;
}

void require_deformation(const KeyDeformation& deformation, const std::vector<KeyShape>& shapes) {
  if (deformation.key + 1 >= shapes.size())
    throw InputError("deformation", fmt::format("shape {} is not on its way to another", deformation.key + 1),
                     "deform a shape before the last");
  const auto& name = shapes[deformation.key].name;
  if (deformation.from_mm.size() != dimension_of(shapes.front().shape))
    throw InputError(name.empty() ? "shape" : name,
                     fmt::format("a point that moves it has {} coordinates", deformation.from_mm.size()),
                     "give two for figures, three for bodies");
  if (!(deformation.during.from >= 0 && deformation.during.to <= 1))
    throw InputError(name.empty() ? "shape" : name, "its deformation is not within the way to the next shape",
                     "give times within 0 and 1");
}

PointDeformation in_space_time(const KeyDeformation& deformation, double length_mm) {
  const double way_mm =
      deformation.from_mm.size() == deformation.to_mm.size() ? (deformation.to_mm - deformation.from_mm).norm() : 0;
  return {.from_mm = deformation.from_mm,
          .to_mm = deformation.to_mm,
          .radius_mm = deformation.radius_mm > 0 ? deformation.radius_mm : default_radius * way_mm,
          .during_mm = {.from = length_mm * deformation.during.from, .to = length_mm * deformation.during.to}};
}

BlendedPair blended_pair(const std::vector<BoxedSolid>& solids, std::size_t first, double length_mm,
                         const BlendMorphOptions& options) {
  const SpaceTimeBlend blend = blend_between(solids[first], solids[first + 1], length_mm, options);
  BlendedPair pair{.space_time = {}, .changing_mm = blend.slab_mm};
  SolidFunction leaving = cylinder(solids[first].solid);
  for (const KeyDeformation& deformation : options.deformations) {
    if (deformation.key != first) continue;
    leaving = deformed(std::move(leaving), in_space_time(deformation, length_mm));
    pair.changing_mm.from = std::min(pair.changing_mm.from, length_mm * deformation.during.from);
  }
  pair.space_time = space_time_blend(std::move(leaving), cylinder(solids[first + 1].solid), blend);
  return pair;
}

}  // namespace

Morph blend_morph(const std::vector<KeyShape>& shapes, const BlendMorphOptions& options, const Progress& progress) {
  require_morphable(shapes);
  require_distances(shapes);
  for (const KeyDeformation& deformation : options.deformations) require_deformation(deformation, shapes);
  const Stopwatch watch;
  const SlicePose pose = common_pose(shapes);
  const double side_mm = box_of(shapes).sizes().maxCoeff();
  BlendedMorph morph{.shapes = shapes, .pairs = {}, .places = key_places(shapes, KeyLayout::line)};
  const double slab = options.slab.to - options.slab.from;
  morph.length_mm = options.length_mm.value_or(slab > 0 ? default_slab * side_mm / slab : side_mm);
  if (!(morph.length_mm > 0))
    throw InputError("blend", fmt::format("a way of {:g} mm between key shapes", morph.length_mm),
                     "give a length above 0");
  const double fine_mm = dimension_of(shapes.front().shape) == 2 ? pose.spacing_mm.minCoeff() : 1e-2 * side_mm;
  morph.resolution_mm = options.resolution_mm > 0 ? options.resolution_mm : fine_mm;
  std::vector<BoxedSolid> solids;
  for (const KeyShape& shape : shapes) solids.push_back(boxed_solid(shape, pose));
  for (std::size_t i = 0; i + 1 < shapes.size(); ++i) {
    progress.report("blend", static_cast<double>(i) / static_cast<double>(shapes.size() - 1));
    morph.pairs.push_back(blended_pair(solids, i, morph.length_mm, options));
  }
  MorphReport report;
  report.method = "blend";
  report.spacing_mm = morph.length_mm;
  report.resolution_mm = morph.resolution_mm;
  report.constraint_seconds = watch.seconds();
  KeyPlaces places = morph.places;
  return Morph(blend_sections(std::move(morph)), std::move(places), std::move(report));
}

}  // namespace isostack
