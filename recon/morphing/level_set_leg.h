#pragma once

#include <memory>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/morphing/level_set_morph.h"
#include "recon/morphing/shape.h"
#include "recon/morphing/shape_transform.h"

namespace isostack {

/// One key shape becoming the next.
class LevelSetLeg {
 public:
  virtual ~LevelSetLeg() = default;
  virtual bool overlaps() const = 0;
  virtual std::vector<UnsharedPart> unshared() const = 0;
  virtual void seed_unshared() = 0;
  virtual void run(const Progress& progress) = 0;
  virtual LevelSetCourse course() const = 0;
  /// After the run: the shapes at these shares of the way, in [0, 1], ascending.
  virtual std::vector<Shape> shapes_at(const std::vector<double>& shares, const Progress& progress) const = 0;
};

/// What a leg is made of. Figures have one pose.
struct LegShapes {
  KeyShape from, to;
  ShapeTransform transform;      ///< from the coordinates of `from` to those of `to`
  LevelSetMorphOptions options;  ///< resolution_mm > 0

  /// `to` in the coordinates of `from`.
  KeyShape target() const { return {.name = to.name, .shape = transform.moved_back(to.shape)}; }
};

std::shared_ptr<LevelSetLeg> figure_leg(LegShapes shapes);

/// Throws SolveError when the nodes do not fit into memory.
std::shared_ptr<LevelSetLeg> body_leg(LegShapes shapes, const Progress& progress);

}  // namespace isostack
