#include "recon/subdivision/domain_growth.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// Two directions to move in at p.
Eigen::Matrix<double, 3, 2> axes_at(const SurfaceDomain& domain, const Eigen::Vector3d& p) {
  Eigen::Matrix<double, 3, 2> axes;
  if (domain.genus > 0) {
    axes << 1, 0, 0, 1, 0, 0;
    return axes;
  }
  const Eigen::Vector3d other = std::abs(p.x()) < 0.6 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  axes.col(0) = p.cross(other).normalized();
  axes.col(1) = p.cross(axes.col(0));
  return axes;
}

}  // namespace

DomainGrowth::DomainGrowth(const TriangleMesh& mesh, DomainMesh start)
    : mesh_(mesh),
      drawn_(std::move(start)),
      surface_(drawn_.triangles.size()),
      around_(drawn_.positions.size()),
      pinned_(drawn_.positions.size(), false) {
  double sum = 0;
  for (const Eigen::Vector3i& t : mesh.triangles)
    sum += (mesh.vertices_mm[at(t[0])] - mesh.vertices_mm[at(t[1])]).squaredNorm();
  least_squared_mm2_ = 1e-6 * sum / static_cast<double>(mesh.triangles.size());  // a thousandth of an edge
  for (int t = 0; t < static_cast<int>(drawn_.triangles.size()); ++t) {
    if (drawn_.triangles[at(t)][0] < 0) continue;
    for (const int v : drawn_.triangles[at(t)]) around_[at(v)].push_back(t);
    measure(t);
  }
}

void DomainGrowth::measure(int triangle) {
  const Eigen::Vector3i& t = drawn_.triangles[at(triangle)];
  surface_[at(triangle)] = surface_triangle(mesh_.vertices_mm[at(t[0])], mesh_.vertices_mm[at(t[1])],
                                            mesh_.vertices_mm[at(t[2])], least_squared_mm2_);
}

int DomainGrowth::number_of(int vertex, int triangle) const {
  const Eigen::Vector3i& t = drawn_.triangles[at(triangle)];
  return t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
}

/// Sides are kept with the squared lengths in the order (own corner, q, r).
void DomainGrowth::collect_star(int vertex) {
  star_.clear();
  for (const int t : around_[at(vertex)]) {
    const int own = number_of(vertex, t);
    star_.push_back({&surface_[at(t)], drawn_.corner(t, (own + 1) % 3, own), drawn_.corner(t, (own + 2) % 3, own)});
    // The stretch of a triangle does not depend on where its corners begin; own corner first.
    if (own != 0) {
      SurfaceTriangle& turned = surface_[at(t)];
      Eigen::Vector3i& corners = drawn_.triangles[at(t)];
      CornerOffsets& offsets = drawn_.offsets[at(t)];
      const auto turn = [own](auto& three) { std::rotate(&three[0], &three[0] + own, &three[0] + 3); };
      turn(turned.squared_sides);
      turn(corners);
      turn(offsets);
    }
  }
}

bool DomainGrowth::is_seen_from(const Eigen::Vector3d& p) const {
  return std::all_of(star_.begin(), star_.end(), [&](const Side& side) {
    const double least = 1e-9 * (side.q - p).norm() * (side.r - p).norm();
    return drawn_.domain.orientation(p, side.q, side.r) > least;
  });
}

double DomainGrowth::star_stretch(const Eigen::Vector3d& p) const {
  double sum = 0;
  for (const Side& side : star_) sum += stretch(*side.triangle, p, side.q, side.r);
  return sum;
}

Eigen::Vector2d DomainGrowth::star_gradient(const Eigen::Vector3d& p, const Eigen::Matrix<double, 3, 2>& axes) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Side& side : star_) add_stretch_gradient(*side.triangle, p, side.q, side.r, sum);
  return axes.transpose() * sum;
}

void DomainGrowth::relax(int vertex) {
  if (pinned_[at(vertex)]) return;
  collect_star(vertex);
  const Eigen::Vector3d p = drawn_.positions[at(vertex)];
  const Eigen::Matrix<double, 3, 2> axes = axes_at(drawn_.domain, p);
  double radius = std::numeric_limits<double>::max();
  for (const Side& side : star_) radius = std::min(radius, (side.q - p).norm());
  const Eigen::Vector2d slope = star_gradient(p, axes);
  const double before = star_stretch(p), h = 1e-4 * radius;
  Eigen::Matrix2d curvature;
  for (int i = 0; i < 2; ++i)
    curvature.col(i) = (star_gradient(drawn_.domain.onto(p + h * axes.col(i)), axes) - slope) / h;
  curvature = (curvature + curvature.transpose()).eval() / 2;
  Eigen::Vector2d step = -slope.normalized() * radius / 2;
  if (curvature.determinant() > 0 && curvature.trace() > 0) step = -curvature.inverse() * slope;
  if (step.norm() > radius) step *= radius / step.norm();
  for (int halving = 0; halving < 8; ++halving, step /= 2) {
    const Eigen::Vector3d there = drawn_.domain.onto(p + axes * step);
    if (!is_seen_from(there) || star_stretch(there) >= before) continue;
    drawn_.positions[at(vertex)] = there;
    return;
  }
}

void DomainGrowth::relax_round(int vertex) {
  relax(vertex);
  std::vector<int> ring;
  for (const int t : around_[at(vertex)]) ring.push_back(drawn_.triangles[at(t)][(number_of(vertex, t) + 1) % 3]);
  for (const int v : ring) relax(v);
  relax(vertex);
}

void DomainGrowth::sweep() {
  for (int v = 0; v < static_cast<int>(around_.size()); ++v)
    if (!around_[at(v)].empty()) relax(v);
}

double DomainGrowth::total_stretch() const {
  double sum = 0;
  for (int t = 0; t < static_cast<int>(drawn_.triangles.size()); ++t)
    if (drawn_.triangles[at(t)][0] >= 0)
      sum += stretch(surface_[at(t)], drawn_.corner(t, 0, 0), drawn_.corner(t, 1, 0), drawn_.corner(t, 2, 0));
  return sum;
}

void DomainGrowth::reshape() {
  if (drawn_.domain.genus == 0) return;
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (int t = 0; t < static_cast<int>(drawn_.triangles.size()); ++t) {
    if (drawn_.triangles[at(t)][0] < 0) continue;
    const Eigen::Vector3d p = drawn_.corner(t, 0, 0), q = drawn_.corner(t, 1, 0), r = drawn_.corner(t, 2, 0);
    const auto product = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      const Eigen::Matrix2d m = a.head<2>() * b.head<2>().transpose();
      return Eigen::Matrix2d((m + m.transpose()) / 2);
    };
    const SurfaceTriangle& s = surface_[at(t)];
    sum += s.area / (q - p).cross(r - p).squaredNorm() *
           (s.squared_sides[0] * product(q - p, r - p) + s.squared_sides[1] * product(p - q, r - q) +
            s.squared_sides[2] * product(p - r, q - r));
  }
  const Eigen::Matrix2d metric = sum.inverse() * std::sqrt(sum.determinant());
  const Eigen::Matrix2d linear = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(metric).operatorSqrt();
  for (Eigen::Vector3d& p : drawn_.positions) p.head<2>() = linear * p.head<2>();
  drawn_.domain.periods.topRows<2>() = linear * drawn_.domain.periods.topRows<2>();
}

bool DomainGrowth::displace(std::vector<Eigen::Vector3d> positions) {
  std::swap(drawn_.positions, positions);
  for (int t = 0; t < static_cast<int>(drawn_.triangles.size()); ++t) {
    const Eigen::Vector3d p = drawn_.corner(t, 0, 0), q = drawn_.corner(t, 1, 0), r = drawn_.corner(t, 2, 0);
    if (drawn_.domain.orientation(p, q, r) > 1e-9 * (q - p).norm() * (r - p).norm()) continue;
    std::swap(drawn_.positions, positions);
    return false;
  }
  return true;
}

DomainMesh DomainGrowth::drawn() const {
  DomainMesh made = drawn_;
  for (std::size_t t = 0; t < made.triangles.size(); ++t) {
    Eigen::Vector3i& corners = made.triangles[t];
    if (corners[0] < 0) continue;
    const auto first = std::find(corners.begin(), corners.end(), mesh_.triangles[t][0]) - corners.begin();
    std::rotate(made.offsets[t].begin(), made.offsets[t].begin() + first, made.offsets[t].end());
    corners = mesh_.triangles[t];
  }
  return made;
}

void DomainGrowth::restore_triangles(const VertexSplit& split) {
  auto& at_kept = around_[at(split.kept)];
  auto& at_gone = around_[at(split.gone)];
  for (const int t : split.moved) {
    drawn_.triangles[at(t)][number_of(split.kept, t)] = split.gone;
    at_kept.erase(std::find(at_kept.begin(), at_kept.end(), t));
    at_gone.push_back(t);
    measure(t);
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const int t = split.flattened[side];
    const Eigen::Vector3i& corners = split.flattened_were[side];
    const int third = corners.sum() - split.kept - split.gone;
    const auto has_third = [&](int other) { return (drawn_.triangles[at(other)].array() == third).any(); };
    // Beside it lies a triangle with the same edge gone – third; where `gone` is now, `kept` was.
    const int beside = *std::find_if(split.moved.begin(), split.moved.end(), has_third);
    const CornerOffsets& copies = drawn_.offsets[at(beside)];
    for (int c = 0; c < 3; ++c)
      drawn_.offsets[at(t)][at(c)] = copies[at(number_of(corners[c] == third ? third : split.gone, beside))];
    drawn_.triangles[at(t)] = corners;
    for (const int v : corners) around_[at(v)].push_back(t);
    measure(t);
  }
}

/// From the kept vertex half-way into the angle of the triangles that move: all of them, and both new ones, are seen
/// from there, near enough (the angle is less than a full turn).
void DomainGrowth::place(const VertexSplit& split) {
  const Eigen::Vector3d p = drawn_.positions[at(split.kept)];
  const Eigen::Matrix<double, 3, 2> axes = axes_at(drawn_.domain, p);
  const auto direction = [&](const Eigen::Vector3d& q) {
    const Eigen::Vector2d d = axes.transpose() * (q - p);
    return std::atan2(d.y(), d.x());
  };
  // The fan of moved triangles begins at the third corner of the new triangle that runs gone → kept.
  double angle = 0, first = 0, nearest = std::numeric_limits<double>::max();
  const auto is_first = [&](const Eigen::Vector3i& t) {
    const int kept = t[0] == split.kept ? 0 : t[1] == split.kept ? 1 : 2;
    return t[(kept + 1) % 3] != split.gone;
  };
  const std::size_t start = is_first(split.flattened_were[0]) ? 0 : 1;
  const int third = split.flattened_were[start].sum() - split.kept - split.gone;
  drawn_.positions[at(split.gone)] = p;
  collect_star(split.gone);
  for (std::size_t s = 0; s < star_.size(); ++s) {
    const int t = around_[at(split.gone)][s];
    if (t == split.flattened[0] || t == split.flattened[1]) continue;
    const double from = direction(star_[s].q);
    angle += std::remainder(direction(star_[s].r) - from, 2 * std::numbers::pi);
    if (drawn_.triangles[at(t)][(number_of(split.gone, t) + 1) % 3] == third) first = from;
    nearest = std::min({nearest, (star_[s].q - p).norm(), (star_[s].r - p).norm()});
  }
  const double middle = first + angle / 2;
  const Eigen::Vector3d way = axes * Eigen::Vector2d(std::cos(middle), std::sin(middle));
  double best = std::numeric_limits<double>::max();
  Eigen::Vector3d found = p;
  for (double far = nearest / 2; far > 1e-9 * nearest; far *= 0.7) {
    const Eigen::Vector3d there = drawn_.domain.onto(p + far * way);
    if (!is_seen_from(there)) continue;
    const double value = star_stretch(there);
    if (value >= best) break;
    best = value;
    found = there;
  }
  if (best == std::numeric_limits<double>::max())
    throw SolveError(mesh_.name.empty() ? "surface" : mesh_.name, "the mesh could not be spread out over its domain",
                     "retriangulate it, so that no triangles are long and thin");
  drawn_.positions[at(split.gone)] = found;
}

void DomainGrowth::undo(const VertexSplit& split) {
  restore_triangles(split);
  place(split);
}

}  // namespace isostack
