#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "recon/distance/solid.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/point_triangle.h"

namespace isostack {

using Eigen::Vector3d;

namespace {

/// |p|-like: how far out a point (own axes, in radii) is; 1 on the superellipsoid.
double reach_of(const Eigen::Vector2d& exponents, const Vector3d& in_radii) {
  const double largest = in_radii.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return 0;
  const Vector3d p = in_radii.cwiseAbs() / largest;  // no overflow however square it is
  const double e1 = exponents[0], e2 = exponents[1];
  const double round = std::pow(std::pow(p.x(), 2 / e2) + std::pow(p.y(), 2 / e2), e2 / e1);
  return largest * std::pow(round + std::pow(p.z(), 2 / e1), e1 / 2);
}

/// implicit_value with `zero` taken for 0: what the rules of the tables make of a point on the surface of that part.
double value_with(const CsgSolid& solid, const CsgSolid* zero, const Vector3d& point_mm) {
  using Kind = CsgSolid::Kind;
  if (solid.kind == Kind::superellipsoid)
    return &solid == zero
               ? 0
               : 1 - reach_of(solid.exponents, (solid.to_world.inverse() * point_mm).cwiseQuotient(solid.radii_mm));
  double value = value_with(solid.parts.front(), zero, point_mm);
  for (std::size_t i = 1; i < solid.parts.size(); ++i) {
    const double next = value_with(solid.parts[i], zero, point_mm);
    if (solid.kind == Kind::set_union)
      value = std::max(value, next);
    else
      value = std::min(value, solid.kind == Kind::difference ? -next : next);
  }
  return value;
}

void gather_leaves(const CsgSolid& solid, std::vector<const CsgSolid*>& leaves) {
  if (solid.kind == CsgSolid::Kind::superellipsoid) leaves.push_back(&solid);
  for (const CsgSolid& part : solid.parts) gather_leaves(part, leaves);
}

/// Samples the part of one superellipsoid's surface that is on the solid's.
class Sampler {
 public:
  Sampler(const CsgSolid& solid, const CsgSolid& leaf, double tolerance_mm, TriangleMesh& samples)
      : solid_(solid), leaf_(leaf), tolerance_mm_(tolerance_mm), samples_(samples) {
    largest_mm_ = 2 * (leaf.to_world.linear() * leaf.radii_mm.asDiagonal()).norm() / 64;
  }

  void run() {
    for (int octant = 0; octant < 8; ++octant) {
      const Vector3d x = (octant & 1 ? 1 : -1) * Vector3d::UnitX(), y = (octant & 2 ? 1 : -1) * Vector3d::UnitY(),
                     z = (octant & 4 ? 1 : -1) * Vector3d::UnitZ();
      // Three quadrilaterals about the octant's middle: square shapes have their edges and corners there.
      const Vector3d middle = x + y + z;
      for (const auto& [a, b, c] : {std::array{x, y, z}, std::array{y, z, x}, std::array{z, x, y}}) {
        split({a, a + b, middle}, 0);
        split({a, middle, a + c}, 0);
      }
    }
  }

 private:
  using Directions = std::array<Vector3d, 3>;  ///< from the centre, own axes, in radii

  Vector3d surface(const Vector3d& direction) const {
    return leaf_.to_world * leaf_.radii_mm.cwiseProduct(direction / reach_of(leaf_.exponents, direction));
  }
  bool is_on_solid(const Vector3d& point_mm) const { return std::abs(value_with(solid_, &leaf_, point_mm)) <= 1e-12; }

  void split(const Directions& d, int depth) {
    const Triangle corners{surface(d[0]), surface(d[1]), surface(d[2])};
    const Directions between{d[0] + d[1], d[1] + d[2], d[2] + d[0]};
    const std::array<Vector3d, 4> checks{surface(between[0]), surface(between[1]), surface(between[2]),
                                         surface(d[0] + d[1] + d[2])};
    double off_mm = 0, longest_mm = 0;
    for (const Vector3d& check : checks)
      off_mm = std::max(off_mm, (closest_point_on_triangle(corners, check) - check).norm());
    int on = 0;
    for (int i = 0; i < 3; ++i) {
      longest_mm = std::max(
          longest_mm, (corners[static_cast<std::size_t>(i)] - corners[static_cast<std::size_t>((i + 1) % 3)]).norm());
      on += is_on_solid(corners[static_cast<std::size_t>(i)]) ? 1 : 0;
    }
    for (const Vector3d& check : checks) on += is_on_solid(check) ? 1 : 0;
    const bool is_partly_on = on > 0 && on < 7;
    const bool is_fine = longest_mm <= largest_mm_ && (on == 0 || off_mm <= 0.5 * tolerance_mm_) &&
                         (!is_partly_on || longest_mm <= tolerance_mm_);
    constexpr int deepest = 20;
    if (!is_fine && depth < deepest) {
      const auto half = [](const Vector3d& direction) { return (0.5 * direction).eval(); };
      const Directions m{half(between[0]), half(between[1]), half(between[2])};
      for (const Directions& part : {Directions{d[0], m[0], m[2]}, Directions{m[0], d[1], m[1]},
                                     Directions{m[2], m[1], d[2]}, Directions{m[0], m[1], m[2]}})
        split(part, depth + 1);
      return;
    }
    if (on > 0) emit(corners);
  }

  void emit(const Triangle& corners) {
    Eigen::Vector3i triangle;
    for (int i = 0; i < 3; ++i) triangle[i] = vertex_at(corners[static_cast<std::size_t>(i)]);
    samples_.triangles.push_back(triangle);
  }

  /// Neighbours compute the corners they share from the same numbers.
  int vertex_at(const Vector3d& point_mm) {
    const auto [at, is_new] = vertices_.try_emplace({point_mm.x(), point_mm.y(), point_mm.z()},
                                                    static_cast<int>(samples_.vertices_mm.size()));
    if (is_new) samples_.vertices_mm.push_back(point_mm);
    return at->second;
  }

  const CsgSolid& solid_;
  const CsgSolid& leaf_;
  const double tolerance_mm_;
  double largest_mm_;
  TriangleMesh& samples_;
  std::map<std::array<double, 3>, int> vertices_;
};

}  // namespace

double implicit_value(const CsgSolid& solid, const Vector3d& point_mm) { return value_with(solid, nullptr, point_mm); }

TriangleMesh solid_samples(const CsgSolid& solid, double tolerance_mm) {
  TriangleMesh samples;
  samples.name = solid.name;
  std::vector<const CsgSolid*> leaves;
  gather_leaves(solid, leaves);
  for (const CsgSolid* leaf : leaves) Sampler(solid, *leaf, tolerance_mm, samples).run();
  if (samples.triangles.empty())
    throw InputError(solid.name.empty() ? "solid" : solid.name, "it is empty after the set operations",
                     "let its parts overlap, and do not take all away");
  return samples;
}

}  // namespace isostack
