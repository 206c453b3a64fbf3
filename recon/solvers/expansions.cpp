#include "recon/solvers/expansions.h"

#include <algorithm>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "recon/solvers/expansions.cpp"
#include <hwy/foreach_target.h>  // compiles the SIMD part once per instruction set

#include "recon/solvers/radial_simd-inl.h"

#ifndef ISOSTACK_EXPANSIONS_ONCE
#define ISOSTACK_EXPANSIONS_ONCE
namespace isostack {
constexpr int most_nodes = 32;  ///< along an axis
}  // namespace isostack
#endif

HWY_BEFORE_NAMESPACE();
namespace isostack {
namespace HWY_NAMESPACE {

/// The Lagrange polynomials of one axis, and their first derivatives up to `Derivatives`, at a vector
/// of positions: ℓ_a = factor_a · ∏_{b<a}(t − node_b) · ∏_{b>a}(t − node_b).
template <int Derivatives>
struct AxisBasis {
  Vec value[most_nodes];
  Vec slope[Derivatives >= 1 ? most_nodes : 1];
  Vec bend[Derivatives >= 2 ? most_nodes : 1];

  HWY_INLINE void compute(const NodeGrid& grid, int axis, Vec t, double half_width) {
    const Vec zero = hn::Zero(Lanes());
    if (grid.count(axis) == 1) {
      value[0] = set(1.0);
      if constexpr (Derivatives >= 1) slope[0] = zero;
      if constexpr (Derivatives >= 2) bend[0] = zero;
      return;
    }
    const int n = grid.order();
    const double* nodes = grid.nodes().data();
    Vec p = set(1.0), dp = zero, ddp = zero;
    for (int a = 0; a < n; ++a) {  // products from the left
      value[a] = p;
      if constexpr (Derivatives >= 1) slope[a] = dp;
      if constexpr (Derivatives >= 2) bend[a] = ddp;
      const Vec d = hn::Sub(t, set(nodes[a]));
      if constexpr (Derivatives >= 2) ddp = hn::MulAdd(ddp, d, hn::Add(dp, dp));
      if constexpr (Derivatives >= 1) dp = hn::MulAdd(dp, d, p);
      p = hn::Mul(p, d);
    }
    const Vec per_length = set(1 / half_width);
    p = set(1.0), dp = zero, ddp = zero;
    for (int a = n - 1; a >= 0; --a) {  // times products from the right
      const Vec factor = set(grid.factors()[static_cast<std::size_t>(a)]);
      const Vec v = value[a];
      value[a] = hn::Mul(factor, hn::Mul(v, p));
      const Vec d = hn::Sub(t, set(nodes[a]));
      if constexpr (Derivatives >= 1) {
        const Vec s = slope[a];
        const Vec scaled = hn::Mul(factor, per_length);
        slope[a] = hn::Mul(scaled, hn::MulAdd(s, p, hn::Mul(v, dp)));
        if constexpr (Derivatives >= 2) {
          const Vec both = hn::Mul(s, dp);
          bend[a] =
              hn::Mul(hn::Mul(scaled, per_length), hn::MulAdd(bend[a], p, hn::MulAdd(v, ddp, hn::Add(both, both))));
          ddp = hn::MulAdd(ddp, d, hn::Add(dp, dp));
        }
        dp = hn::MulAdd(dp, d, p);
      }
      p = hn::Mul(p, d);
    }
  }
};

template <int Derivatives>
struct PointBasis {
  AxisBasis<Derivatives> x, y, z;

  HWY_INLINE void compute(const NodeGrid& grid, const CellFrame& frame, Vec px, Vec py, Vec pz) {
    const Vec per_half = set(1 / frame.half_width);
    x.compute(grid, 0, hn::Mul(hn::Sub(px, set(frame.centre[0])), per_half), frame.half_width);
    y.compute(grid, 1, hn::Mul(hn::Sub(py, set(frame.centre[1])), per_half), frame.half_width);
    z.compute(grid, 2, hn::Mul(hn::Sub(pz, set(frame.centre[2])), per_half), frame.half_width);
  }
};

/// Loads up to a vector of values; beyond `left` they are 0 and stay harmless.
HWY_INLINE Vec load_some(const double* from, std::size_t left) {
  const Lanes tag;
  if (left >= hn::Lanes(tag)) return hn::LoadU(tag, from);
  HWY_ALIGN double buffer[HWY_MAX_BYTES / sizeof(double)] = {};
  std::copy_n(from, left, buffer);
  return hn::Load(tag, buffer);
}

HWY_INLINE void add_some(Vec v, double* to, std::size_t left) {
  const Lanes tag;
  if (left >= hn::Lanes(tag)) return hn::StoreU(hn::Add(hn::LoadU(tag, to), v), tag, to);
  HWY_ALIGN double buffer[HWY_MAX_BYTES / sizeof(double)];
  hn::Store(v, tag, buffer);
  for (std::size_t k = 0; k < left; ++k) to[k] += buffer[k];
}

void add_points_simd(const NodeGrid& grid, const CellFrame& frame, const PointArrays& points, const double* weights,
                     double* expansion) {
  constexpr std::size_t chunk = 64;
  const Lanes tag;
  const std::size_t lanes = hn::Lanes(tag);
  const int nx = grid.count(0), ny = grid.count(1), nz = grid.count(2);
  HWY_ALIGN double bx[most_nodes * chunk], by[most_nodes * chunk], bz[most_nodes * chunk];
  for (std::size_t begin = 0; begin < points.count; begin += chunk) {
    const std::size_t end = std::min(begin + chunk, points.count);
    std::size_t padded = 0;
    for (std::size_t i = begin; i < end; i += lanes, padded += lanes) {
      PointBasis<0> basis;
      basis.compute(grid, frame, load_some(points.x + i, end - i), load_some(points.y + i, end - i),
                    load_some(points.z + i, end - i));
      const Vec w = load_some(weights + i, end - i);  // 0 beyond the end
      for (int a = 0; a < nx; ++a)
        hn::Store(hn::Mul(w, basis.x.value[a]), tag, bx + static_cast<std::size_t>(a) * chunk + padded);
      for (int b = 0; b < ny; ++b) hn::Store(basis.y.value[b], tag, by + static_cast<std::size_t>(b) * chunk + padded);
      for (int c = 0; c < nz; ++c) hn::Store(basis.z.value[c], tag, bz + static_cast<std::size_t>(c) * chunk + padded);
    }
    double* node = expansion;
    for (int a = 0; a < nx; ++a)
      for (int b = 0; b < ny; ++b) {
        Vec product[chunk];
        for (std::size_t k = 0, v = 0; k < padded; k += lanes, ++v)
          product[v] = hn::Mul(hn::Load(tag, bx + static_cast<std::size_t>(a) * chunk + k),
                               hn::Load(tag, by + static_cast<std::size_t>(b) * chunk + k));
        for (int c = 0; c < nz; ++c, node += sibling_lanes) {
          Vec sum = hn::Zero(tag);
          for (std::size_t k = 0, v = 0; k < padded; k += lanes, ++v)
            sum = hn::MulAdd(product[v], hn::Load(tag, bz + static_cast<std::size_t>(c) * chunk + k), sum);
          *node += hn::GetLane(hn::SumOfLanes(tag, sum));
        }
      }
  }
}

template <int Derivatives>
HWY_INLINE void add_at_points(const NodeGrid& grid, const CellFrame& frame, const ExpansionView& expansion,
                              const PointArrays& points, const SumArrays& sums) {
  const Lanes tag;
  const Vec zero = hn::Zero(tag);
  const int nx = grid.count(0), ny = grid.count(1), nz = grid.count(2);
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(tag)) {
    const std::size_t left = points.count - i;
    PointBasis<Derivatives> basis;
    basis.compute(grid, frame, load_some(points.x + i, left), load_some(points.y + i, left),
                  load_some(points.z + i, left));
    Vec value = zero, gx = zero, gy = zero, gz = zero;
    Vec xx = zero, yy = zero, zz = zero, yz = zero, xz = zero, xy = zero;
    const double* node = expansion.values;
    for (int a = 0; a < nx; ++a) {
      Vec u = zero, uy = zero, uz = zero, uyy = zero, uzz = zero, uyz = zero;
      for (int b = 0; b < ny; ++b) {
        Vec v = zero, vz = zero, vzz = zero;
        for (int c = 0; c < nz; ++c, node += expansion.stride) {
          const Vec e = set(*node);
          v = hn::MulAdd(e, basis.z.value[c], v);
          if constexpr (Derivatives >= 1) vz = hn::MulAdd(e, basis.z.slope[c], vz);
          if constexpr (Derivatives >= 2) vzz = hn::MulAdd(e, basis.z.bend[c], vzz);
        }
        u = hn::MulAdd(v, basis.y.value[b], u);
        if constexpr (Derivatives >= 1) {
          uy = hn::MulAdd(v, basis.y.slope[b], uy);
          uz = hn::MulAdd(vz, basis.y.value[b], uz);
        }
        if constexpr (Derivatives >= 2) {
          uyy = hn::MulAdd(v, basis.y.bend[b], uyy);
          uyz = hn::MulAdd(vz, basis.y.slope[b], uyz);
          uzz = hn::MulAdd(vzz, basis.y.value[b], uzz);
        }
      }
      const Vec x = basis.x.value[a];
      value = hn::MulAdd(u, x, value);
      if constexpr (Derivatives >= 1) {
        const Vec dx = basis.x.slope[a];
        gx = hn::MulAdd(u, dx, gx);
        gy = hn::MulAdd(uy, x, gy);
        gz = hn::MulAdd(uz, x, gz);
        if constexpr (Derivatives >= 2) {
          xx = hn::MulAdd(u, basis.x.bend[a], xx);
          yy = hn::MulAdd(uyy, x, yy);
          zz = hn::MulAdd(uzz, x, zz);
          yz = hn::MulAdd(uyz, x, yz);
          xz = hn::MulAdd(uz, dx, xz);
          xy = hn::MulAdd(uy, dx, xy);
        }
      }
    }
    add_some(value, sums.value + i, left);
    if constexpr (Derivatives >= 1) {
      add_some(gx, sums.gradient[0] + i, left);
      add_some(gy, sums.gradient[1] + i, left);
      add_some(gz, sums.gradient[2] + i, left);
    }
    if constexpr (Derivatives >= 2) {
      const Vec hessian[6] = {xx, yy, zz, yz, xz, xy};
      for (int k = 0; k < 6; ++k) add_some(hessian[k], sums.hessian[k] + i, left);
    }
  }
}

void add_at_points_simd(const NodeGrid& grid, const CellFrame& frame, const ExpansionView& expansion,
                        const PointArrays& points, const SumArrays& sums) {
  if (sums.hessian[0]) return add_at_points<2>(grid, frame, expansion, points, sums);
  if (sums.gradient[0]) return add_at_points<1>(grid, frame, expansion, points, sums);
  add_at_points<0>(grid, frame, expansion, points, sums);
}

/// out[i][b][k] = Σ_a in[i][a][k] · matrix[a][b], every element eight lanes.
void contract(const double* in, std::size_t before, std::size_t inputs, std::size_t after, const double* matrix,
              std::size_t outputs, double* out) {
  const Lanes tag;
  for (std::size_t lane = 0; lane < sibling_lanes; lane += hn::Lanes(tag))
    for (std::size_t i = 0; i < before; ++i)
      for (std::size_t k = 0; k < after; ++k) {
        const double* column = in + (i * inputs * after + k) * sibling_lanes + lane;
        double* result = out + (i * outputs * after + k) * sibling_lanes + lane;
        for (std::size_t b = 0; b < outputs; ++b) {
          Vec sum = hn::Zero(tag);
          for (std::size_t a = 0; a < inputs; ++a)
            sum = hn::MulAdd(hn::LoadU(tag, column + a * after * sibling_lanes),
                             hn::LoadU(tag, matrix + (a * outputs + b) * sibling_lanes + lane), sum);
          hn::StoreU(sum, tag, result + b * after * sibling_lanes);
        }
      }
}

}  // namespace HWY_NAMESPACE
}  // namespace isostack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isostack {

HWY_EXPORT(add_points_simd);
HWY_EXPORT(add_at_points_simd);
HWY_EXPORT(contract);

namespace {

/// Carries eight lanes from one grid to another, axis after axis.
void carry(const NodeGrid& from, const NodeGrid& to, const std::array<std::vector<double>, 3>& matrices,
           const double* in, std::vector<double>& result, std::vector<double>& scratch) {
  const auto n = [](const NodeGrid& grid, int axis) { return static_cast<std::size_t>(grid.count(axis)); };
  const std::size_t most = std::max(from.node_count(), to.node_count()) * sibling_lanes;
  result.resize(most);
  scratch.resize(most);
  const auto step = HWY_DYNAMIC_DISPATCH(contract);
  step(in, 1, n(from, 0), n(from, 1) * n(from, 2), matrices[0].data(), n(to, 0), result.data());
  step(result.data(), n(to, 0), n(from, 1), n(from, 2), matrices[1].data(), n(to, 1), scratch.data());
  step(scratch.data(), n(to, 0) * n(to, 1), n(from, 2), 1, matrices[2].data(), n(to, 2), result.data());
}

}  // namespace

void add_points_to_expansion(const NodeGrid& grid, const CellFrame& frame, const PointArrays& points,
                             const double* weights, double* expansion) {
  HWY_DYNAMIC_DISPATCH(add_points_simd)(grid, frame, points, weights, expansion);
}

void add_expansion_at_points(const NodeGrid& grid, const CellFrame& frame, const ExpansionView& expansion,
                             const PointArrays& points, const SumArrays& sums) {
  HWY_DYNAMIC_DISPATCH(add_at_points_simd)(grid, frame, expansion, points, sums);
}

void add_siblings_to_parent(const GridTransfer& transfer, const double* siblings, double* parent,
                            TransferScratch& scratch) {
  carry(transfer.child, transfer.parent, transfer.to_parent, siblings, scratch.carried, scratch.halfway);
  for (std::size_t q = 0; q < transfer.parent.node_count(); ++q) {
    double sum = 0;
    for (std::size_t lane = 0; lane < sibling_lanes; ++lane) sum += scratch.carried[q * sibling_lanes + lane];
    parent[q * sibling_lanes] += sum;
  }
}

void add_parent_to_siblings(const GridTransfer& transfer, const double* parent, double* siblings,
                            TransferScratch& scratch) {
  const std::size_t nodes = transfer.parent.node_count();
  scratch.spread.resize(nodes * sibling_lanes);
  for (std::size_t q = 0; q < nodes; ++q)
    std::fill_n(scratch.spread.data() + q * sibling_lanes, sibling_lanes, parent[q * sibling_lanes]);
  carry(transfer.parent, transfer.child, transfer.to_child, scratch.spread.data(), scratch.carried, scratch.halfway);
  const std::size_t size = transfer.child.node_count() * sibling_lanes;
  for (std::size_t k = 0; k < size; ++k) siblings[k] += scratch.carried[k];
}

}  // namespace isostack
#endif
