#include <algorithm>

#include "recon/constraints/mesh_constraints.h"
#include "recon/morphing/solved_morph.h"

namespace isostack {

ShapeConstraints body_constraints(const KeyShape& body, const VariationalMorphOptions& options, std::size_t most) {
  TriangleMesh mesh = std::get<TriangleMesh>(body.shape);
  mesh.name = body.name;
  const bool as_in_paper = options.recipe == MorphRecipe::turk_obrien;
  const std::size_t most_samples = std::max<std::size_t>(most / (as_in_paper ? 2 : 3), 4);
  std::vector<MeshSample> samples;
  if (as_in_paper) samples = vertex_samples(mesh);  // spread only when they are too many
  if (!as_in_paper || samples.size() > most_samples) samples = spread_samples(mesh, {.max_samples = most_samples});
  const double side_mm = box_of(body.shape, {}).sizes().maxCoeff();
  return {mesh_constraints(mesh, samples, {.offset_mm = options.offset_fraction * side_mm, .as_in_paper = as_in_paper}),
          static_cast<Eigen::Index>(samples.size())};
}

}  // namespace isostack
