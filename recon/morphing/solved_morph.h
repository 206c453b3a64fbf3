#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "recon/constraints/constraint_set.h"
#include "recon/kernels/kernel.h"
#include "recon/morphing/key_places.h"
#include "recon/morphing/morph.h"
#include "recon/morphing/shape.h"
#include "recon/morphing/variational_morph.h"
#include "recon/solvers/radial_weights.h"

namespace isostack {

// The two halves of a variational morph: shapes -> constraints, solved function -> frames. What lies between does not
// know the shapes' dimension.

/// What one key shape says, in its own n coordinates: boundary points (value 0) first, then the others.
struct ShapeConstraints {
  ConstraintSet set;
  Eigen::Index boundary_count = 0;
};

/// In the slice coordinates of `pose`; at most `most` constraints.
ShapeConstraints figure_constraints(const KeyShape& figure, const SlicePose& pose,
                                    const VariationalMorphOptions& options, std::size_t most);

/// In world mm; at most `most` constraints.
ShapeConstraints body_constraints(const KeyShape& body, const VariationalMorphOptions& options, std::size_t most);

/// One function through all key shapes, f(x, place), in n + m coordinates, mm: the shapes' own come first.
struct SolvedMorph {
  std::vector<KeyShape> shapes;
  std::vector<ShapeConstraints> constraints;  ///< one for each key shape
  KeyPlaces places;
  double spacing_mm = 0;  ///< times places.coordinates: the places in mm
  Kernel kernel;
  Eigen::MatrixXd centres;  ///< (n + m) × N, merged
  RadialWeights solution;
  double tolerance_mm = 0;   ///< of f, for evaluators
  double resolution_mm = 0;  ///< of the frames

  Eigen::VectorXd place_mm(const Eigen::VectorXd& weights) const { return spacing_mm * places.place_at(weights); }
};

std::shared_ptr<const MorphMethod> figure_sections(SolvedMorph solved);
std::shared_ptr<const MorphMethod> body_sections(SolvedMorph solved);

}  // namespace isostack
