#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "recon/morphing/level_set_leg.h"
#include "recon/morphing/level_set_run.h"

namespace isostack {

/// A leg on a lattice of nodes, of whatever dimension: what figures and bodies share.
template <int D>
class LatticeLeg : public LevelSetLeg {
 public:
  bool overlaps() const final { return run_.overlaps(); }

  std::vector<UnsharedPart> unshared() const final {
    std::vector<UnsharedPart> parts;
    for (const UnsharedRegion& region : run_.unshared())
      parts.push_back({.from = shapes_.from.name,
                       .to = shapes_.to.name,
                       .is_hollow = !region.is_inside,
                       .place_mm = place_in_target(run_.target().position_of(region.deepest)),
                       .content = cell_content() * static_cast<double>(region.nodes.size())});
    return parts;
  }

  void seed_unshared() final { run_.seed_unshared(); }
  void run(const Progress& progress) final { run_.run(shapes_.options, progress); }

  LevelSetCourse course() const final {
    LevelSetCourse course = run_.course();
    course.from = shapes_.from.name;
    course.to = shapes_.to.name;
    return course;
  }

  std::vector<Shape> shapes_at(const std::vector<double>& shares, const Progress& progress) const final {
    std::vector<Shape> shapes(shares.size());
    run_.fields_at(shares, progress, [&](std::size_t i, const Field<D>& phi) {
      shapes[i] = shapes_.transform.moved(shape_of(phi, progress), shares[i]);
    });
    return shapes;
  }

 protected:
  using Position = decltype(Field<D>().position_of(0));

  LatticeLeg(LegShapes shapes, Field<D> start, Field<D> target)
      : shapes_(std::move(shapes)), run_(std::move(start), std::move(target)) {}

  const ShapeTransform& transform() const { return shapes_.transform; }
  /// A node's place when all has moved to the target, world mm.
  virtual Eigen::Vector3d place_in_target(const Position& node) const = 0;
  /// mm² or mm³ round a node.
  virtual double cell_content() const = 0;
  /// Where φ ≥ 0, in the coordinates of `from`.
  virtual Shape shape_of(const Field<D>& phi, const Progress& progress) const = 0;

 private:
  LegShapes shapes_;
  LevelSetRun<D> run_;
};

}  // namespace isostack
