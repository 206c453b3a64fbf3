#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/morphing/key_places.h"
#include "recon/morphing/shape.h"
#include "recon/solvers/interpolation_solver.h"
#include "recon/subdivision/fit_report.h"
#include "recon/surface/scalar_field.h"

namespace isostack {

/// What was done to make a morph, for reports.
struct MorphReport {
  std::string method;           ///< "variational", "signed-distance", ...
  double spacing_mm = 0;        ///< mean distance of neighbouring key shapes in the extra dimensions
  std::size_t constraints = 0;  ///< solved for, of all key shapes together
  SolveReport solve;            ///< empty when the method solves nothing
  double constraint_seconds = 0, solve_seconds = 0;
  double resolution_mm = 0;            ///< of the frames
  std::size_t landmarks = 0;           ///< corresponding points that guided it
  std::vector<FitLevelReport> levels;  ///< of a subdivided interpolator
};

/// A morph of figures as one function of x, y (the frames' slice coordinates, mm) and t (mm, 0 at the first key
/// shape), positive inside (Turk & O'Brien 1999, Figure 1). For morphs on a line.
struct SpacetimeField {
  ScalarField field;
  Eigen::AlignedBox3d bounds_mm;          ///< holds all frames; its z runs from the first key shape to the last
  std::vector<Eigen::Vector3d> seeds_mm;  ///< points on the key shapes' boundaries
};

/// What stands behind a Morph: one class for each method. Immutable once made; may be asked from several threads.
class MorphMethod {
 public:
  virtual ~MorphMethod() = default;
  /// The shapes at some places, given by their weights, in this order. Weights were checked. What shapes can share
  /// (a solution, distances) is made once.
  virtual std::vector<Shape> shapes_at(const std::vector<Eigen::VectorXd>& weights, const Progress& progress) const = 0;
  /// None when the method has no such function, or the shapes are not figures on a line.
  virtual std::optional<SpacetimeField> spacetime() const { return std::nullopt; }
  /// Of a method that has the surface of figures in space-time as a mesh: slice coordinates and t, mm, outside out.
  virtual std::optional<TriangleMesh> spacetime_mesh() const { return std::nullopt; }
};

/// Shapes between given shapes, whatever the method. A value: copies share what was solved.
///
/// Figures come out as one ContourSlice in the first key shape's pose, without contours where nothing is left; bodies
/// as closed meshes in world mm with outward normals, without triangles where nothing is left.
class Morph {
 public:
  Morph(std::shared_ptr<const MorphMethod> method, KeyPlaces places, MorphReport report);

  /// At t in [0, 1], from the first key shape to the last; with more than two on a line, through all of them.
  Shape shape_at(double t, const Progress& progress = {}) const;
  /// At the place with these weights (≥ 0, one per key shape, sum 1). Throws InputError on others.
  Shape at(const Eigen::VectorXd& weights, const Progress& progress = {}) const;
  /// A whole sequence, for less than its frames one by one.
  std::vector<Shape> frames(const std::vector<Eigen::VectorXd>& weights, const Progress& progress = {}) const;
  /// `count` ≥ 2 frames evenly in t, both ends included.
  std::vector<Shape> frames(std::size_t count, const Progress& progress = {}) const;

  std::optional<SpacetimeField> spacetime() const { return method_->spacetime(); }
  std::optional<TriangleMesh> spacetime_mesh() const { return method_->spacetime_mesh(); }
  const KeyPlaces& places() const { return places_; }
  const MorphReport& report() const { return report_; }
  const MorphMethod& method() const { return *method_; }

 private:
  std::shared_ptr<const MorphMethod> method_;
  KeyPlaces places_;
  MorphReport report_;
};

}  // namespace isostack
