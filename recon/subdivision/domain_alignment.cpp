#include "recon/subdivision/domain_alignment.h"

#include <tbb/parallel_for.h>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "recon/subdivision/surface_map.h"

namespace isostack {

namespace {

/// Places of a surface by points of its domain, centroid and size taken off.
class Sampler {
 public:
  Sampler(const TriangleMesh& surface, const DomainMesh& drawn) : surface_(surface), drawn_(drawn), walk_(drawn) {
    double area = 0;
    for (const Eigen::Vector3i& t : surface.triangles) {
      const Eigen::Vector3d &a = corner(t[0]), &b = corner(t[1]), &c = corner(t[2]);
      const double share = (b - a).cross(c - a).norm();
      area += share;
      centre_ += share * (a + b + c) / 3;
      square_ += share * (a.squaredNorm() + b.squaredNorm() + c.squaredNorm()) / 3;
    }
    centre_ /= area;
    square_ = square_ / area - centre_.squaredNorm();
  }

  Eigen::Vector3d place(const Eigen::Vector3d& point) {
    const SurfacePlace at = walk_.find(point);
    const Eigen::Vector3i& t = surface_.triangles[static_cast<std::size_t>(at.triangle)];
    return at.shares[0] * corner(t[0]) + at.shares[1] * corner(t[1]) + at.shares[2] * corner(t[2]);
  }
  Eigen::Vector3d normalised_place(const Eigen::Vector3d& point) {
    return (place(point) - centre_) / std::sqrt(square_);
  }
  const DomainMesh& drawn() const { return drawn_; }

 private:
  const Eigen::Vector3d& corner(int v) const { return surface_.vertices_mm[static_cast<std::size_t>(v)]; }

  const TriangleMesh& surface_;
  const DomainMesh& drawn_;
  DomainWalk walk_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double square_ = 0;
};

std::vector<Eigen::Vector3d> sphere_points(int count) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, turn = 2 * std::numbers::pi * i / std::numbers::phi;
    points.emplace_back(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z);
  }
  return points;
}

/// Evenly spread rotations (additive recurrence in three dimensions; Shoemake 1992).
std::vector<Eigen::Quaterniond> spread_rotations(int count) {
  std::vector<Eigen::Quaterniond> made{Eigen::Quaterniond::Identity()};
  const double base = 1.2207440846057596;  // root of x⁴ = x + 1
  for (int i = 1; i < count; ++i) {
    const auto part = [&](int power) { return std::fmod(0.5 + i / std::pow(base, power), 1.0); };
    const double u = part(1), v = 2 * std::numbers::pi * part(2), w = 2 * std::numbers::pi * part(3);
    made.emplace_back(std::sqrt(1 - u) * std::sin(v), std::sqrt(1 - u) * std::cos(v), std::sqrt(u) * std::sin(w),
                      std::sqrt(u) * std::cos(w));
  }
  return made;
}

using RotationCost = std::function<double(const Eigen::Quaterniond&)>;

std::pair<double, Eigen::Quaterniond> downhill(const RotationCost& cost, double value, Eigen::Quaterniond turn) {
  for (double degrees = 16; degrees > 0.4; degrees /= 2)
    for (bool better = true; better;) {
      better = false;
      for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
          const Eigen::AngleAxisd by(sign * degrees * std::numbers::pi / 180, Eigen::Vector3d::Unit(axis));
          const Eigen::Quaterniond next = (by * turn).normalized();
          if (const double there = cost(next); there < value) {
            value = there;
            turn = next;
            better = true;
          }
        }
    }
  return {value, turn};
}

void turn_sphere(Sampler& first, Sampler& second, const std::vector<VertexPair>& pairs, DomainMesh& turned) {
  const std::vector<Eigen::Vector3d> points = sphere_points(150);
  std::vector<Eigen::Vector3d> places;
  for (const Eigen::Vector3d& p : points) places.push_back(first.normalised_place(p));
  const auto corner = [](const DomainMesh& drawn, int v) { return drawn.positions[static_cast<std::size_t>(v)]; };
  const RotationCost cost = [&](const Eigen::Quaterniond& turn) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      sum += (second.normalised_place(turn.conjugate() * points[i]) - places[i]).squaredNorm();
    sum /= static_cast<double>(points.size());
    for (const VertexPair& pair : pairs)
      sum += (turn * corner(second.drawn(), pair.to) - corner(first.drawn(), pair.from)).squaredNorm();
    return sum;
  };
  std::vector<std::pair<double, Eigen::Quaterniond>> starts;
  for (const Eigen::Quaterniond& turn : spread_rotations(400)) starts.emplace_back(cost(turn), turn);
  std::stable_sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::pair<double, Eigen::Quaterniond> best = starts.front();
  for (std::size_t i = 0; i < 5; ++i) {
    const auto found = downhill(cost, starts[i].first, starts[i].second);
    if (found.first < best.first) best = found;
  }
  for (Eigen::Vector3d& p : turned.positions) p = (best.second * p).normalized();
}

/// The same torus by other periods: columns of `basis` are the new ones in terms of the old, determinant ±1.
void rename_periods(DomainMesh& drawn, const Eigen::Matrix2i& basis) {
  const int determinant = basis(0, 0) * basis(1, 1) - basis(0, 1) * basis(1, 0);
  Eigen::Matrix2i inverse;
  inverse << basis(1, 1), -basis(0, 1), -basis(1, 0), basis(0, 0);
  inverse *= determinant;
  drawn.domain.periods = (drawn.domain.periods * basis.cast<double>()).eval();
  for (CornerOffsets& offsets : drawn.offsets)
    for (Eigen::Vector2i& offset : offsets) offset = (inverse * offset).eval();
}

/// Shortest periods, at an angle of 60 to 90 degrees, counter-clockwise.
void shorten_periods(DomainMesh& drawn) {
  for (bool changed = true; changed;) {
    const Eigen::Vector3d a = drawn.domain.periods.col(0), b = drawn.domain.periods.col(1);
    Eigen::Matrix2i basis = Eigen::Matrix2i::Identity();
    if (a.squaredNorm() > b.squaredNorm() * (1 + 1e-9))
      basis << 0, 1, 1, 0;
    else
      basis(0, 1) = -static_cast<int>(std::lround(a.dot(b) / a.squaredNorm()));
    changed = basis != Eigen::Matrix2i::Identity();
    rename_periods(drawn, basis);
  }
  const Eigen::Vector3d a = drawn.domain.periods.col(0), b = drawn.domain.periods.col(1);
  Eigen::Matrix2i basis = Eigen::Matrix2i::Identity();
  if (a.cross(b).z() < 0) basis(1, 1) = -1;
  rename_periods(drawn, basis);
  if (drawn.domain.periods.col(0).dot(drawn.domain.periods.col(1)) >= 0) return;
  basis << 0, -1, 1, 0;  // b and −a
  rename_periods(drawn, basis);
}

void redraw(DomainMesh& drawn, const Eigen::Matrix<double, 3, 2>& periods) {
  const Eigen::Matrix2d linear = periods.topRows<2>() * drawn.domain.periods.topRows<2>().inverse();
  for (Eigen::Vector3d& p : drawn.positions) p.head<2>() = (linear * p.head<2>()).eval();
  drawn.domain.periods = periods;
}

Eigen::Matrix<double, 3, 2> unit_periods() {
  Eigen::Matrix<double, 3, 2> periods;
  periods << 1, 0, 0, 1, 0, 0;
  return periods;
}

constexpr int table = 32;  // points a side, at which tori are compared

std::vector<Eigen::Vector3d> torus_table(Sampler& sampler) {
  std::vector<Eigen::Vector3d> places;
  for (int j = 0; j < table; ++j)
    for (int i = 0; i < table; ++i)
      places.push_back(sampler.normalised_place({(i + 0.5) / table, (j + 0.5) / table, 1}));
  return places;
}

/// Both drawn with unit periods. All ways to name the periods with small numbers, all shifts of the table.
void match_torus(Sampler& first, Sampler& second, DomainMesh& matched) {
  const std::vector<Eigen::Vector3d> here = torus_table(first), there = torus_table(second);
  const auto wrapped = [](int i) { return static_cast<std::size_t>((i % table + table) % table); };
  double best = std::numeric_limits<double>::max();
  Eigen::Matrix2i best_basis = Eigen::Matrix2i::Identity();
  Eigen::Vector2i best_shift = Eigen::Vector2i::Zero();
  for (int code = 0; code < 625; ++code) {
    Eigen::Matrix2i basis;
    basis << code % 5 - 2, code / 5 % 5 - 2, code / 25 % 5 - 2, code / 125 - 2;
    if (basis(0, 0) * basis(1, 1) - basis(0, 1) * basis(1, 0) != 1) continue;
    for (int shift = 0; shift < table * table; ++shift) {
      double sum = 0;
      for (int k = 0; k < table * table && sum < best; k += 5) {
        const Eigen::Vector2i to = basis * Eigen::Vector2i(k % table, k / table);
        sum += (here[static_cast<std::size_t>(k)] -
                there[wrapped(to[1] + shift / table) * table + wrapped(to[0] + shift % table)])
                   .squaredNorm();
      }
      if (sum >= best) continue;
      best = sum;
      best_basis = basis;
      best_shift = {shift % table, shift / table};
    }
  }
  // Point u of the first is at basis u + shift of the second; half a step because table points are middles.
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5);
  const Eigen::Vector2d shift = (best_shift.cast<double>() + half - best_basis.cast<double>() * half) / table;
  for (Eigen::Vector3d& p : matched.positions) p.head<2>() -= shift;
  rename_periods(matched, best_basis);
  redraw(matched, unit_periods());
}

/// Vertices along the periods: some 20, and steps of like length both ways.
Eigen::Vector2i steps_around(const Eigen::Matrix<double, 3, 2>& periods) {
  const double ratio = std::clamp(periods.col(1).norm() / periods.col(0).norm(), 0.25, 4.0);
  const int first = std::max(4, static_cast<int>(std::lround(std::sqrt(20 / ratio))));
  return {first, std::max(4, static_cast<int>(std::lround(first * ratio)))};
}

}  // namespace

AlignedDomains aligned(const std::vector<const TriangleMesh*>& surfaces, std::vector<DomainMesh> drawn,
                       const std::vector<std::vector<VertexPair>>& pairs) {
  AlignedDomains made;
  made.drawn = std::move(drawn);
  const bool is_torus = made.drawn.front().domain.genus == 1;
  if (is_torus) {
    for (DomainMesh& one : made.drawn) shorten_periods(one);
    made.around = steps_around(made.drawn.front().domain.periods);
    for (DomainMesh& one : made.drawn) redraw(one, unit_periods());
  }
  for (std::size_t i = 1; i < surfaces.size(); ++i) {
    const DomainMesh before = made.drawn[i];
    Sampler first(*surfaces[i - 1], made.drawn[i - 1]), second(*surfaces[i], before);
    if (is_torus)
      match_torus(first, second, made.drawn[i]);
    else
      turn_sphere(first, second, pairs.empty() ? std::vector<VertexPair>{} : pairs[i - 1], made.drawn[i]);
  }
  if (!is_torus) return made;
  Eigen::Matrix<double, 3, 2> steps;
  steps << 1, 0.5, 0, std::sqrt(0.75), 0, 0;
  for (DomainMesh& one : made.drawn) redraw(one, steps * made.around.cast<double>().asDiagonal());
  return made;
}

Eigen::Matrix3Xd places_on(const TriangleMesh& surface, const DomainMesh& drawn,
                           const std::vector<Eigen::Vector3d>& points) {
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(points.size()));
  const Sampler sampler(surface, drawn);
  constexpr std::size_t block = 1024;  // always the same, so that results do not depend on the threads
  tbb::parallel_for(std::size_t{0}, (points.size() + block - 1) / block, [&](std::size_t b) {
    Sampler own = sampler;
    for (std::size_t i = b * block; i < std::min(points.size(), (b + 1) * block); ++i)
      places.col(static_cast<Eigen::Index>(i)) = own.place(points[i]);
  });
  return places;
}

}  // namespace isostack
