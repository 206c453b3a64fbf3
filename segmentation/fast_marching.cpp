#include "segmentation/fast_marching.h"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "segmentation/curve_distance.h"
#include "segmentation/eikonal.h"
#include "segmentation/lattice.h"
#include "segmentation/pieces.h"

namespace isostack {

namespace {

/// What is known of a node; `border` is added on the lattice's border.
enum State : std::uint8_t { far = 0, trial = 1, known = 2, beside_curve = 3, border = 4 };
using States = std::vector<std::uint8_t>;

/// One side of the curve. The other side is read beside the curve only, where nothing changes any more.
template <int D>
class Marcher {
 public:
  Marcher(Field<D>& phi, const Lattice<D>& lattice, States& state, double band_mm, bool inside)
      : phi_(phi.values.data()),
        lattice_(lattice),
        state_(state),
        band_mm_(band_mm),
        sign_(inside ? 1 : -1),
        width_mm_(phi.smallest_spacing_mm() / 10),
        buckets_(static_cast<std::size_t>(band_mm / width_mm_) + 1) {}

  void run(const std::vector<std::size_t>& beside) {
    for (const std::size_t node : beside)
      if (is_mine(node) && distance(node) <= band_mm_) update_neighbours(node);
    for (auto& bucket : buckets_) {
      for (std::size_t i = 0; i < bucket.size(); ++i) {  // grows on the way
        const std::size_t node = bucket[i];
        if (state_of(node) != trial) continue;
        set_state(node, known);
        update_neighbours(node);
      }
      std::vector<std::size_t>().swap(bucket);
    }
  }

 private:
  bool is_mine(std::size_t node) const { return is_inside(phi_[node]) == (sign_ > 0); }
  /// As seen from this side: negative across the zero set.
  double distance(std::size_t node) const { return sign_ * static_cast<double>(phi_[node]); }

  int state_of(std::size_t node) const { return state_[node] & ~border; }
  void set_state(std::size_t node, State state) {
    state_[node] = static_cast<std::uint8_t>((state_[node] & border) | state);
  }
  typename Lattice<D>::Sides sides_of(std::size_t node) const {
    return state_[node] & border ? lattice_.sides_of(node) : lattice_.all_sides;
  }

  void update_neighbours(std::size_t node) {
    lattice_.for_each_neighbour(sides_of(node), [&](int, std::ptrdiff_t step) {
      const std::size_t there = lattice_.moved(node, step);
      if (is_mine(there) && state_of(there) <= trial) update(there);
    });
  }

  void update(std::size_t node) {
    UpwindEikonal<D> eikonal;
    const auto sides = sides_of(node);
    for (int axis = 0; axis < D; ++axis) add_upwind(node, axis, sides, eikonal);
    const double found = eikonal.solve();
    if (!(found <= band_mm_) || (state_of(node) == trial && found >= distance(node))) return;
    phi_[node] = static_cast<float>(sign_ * found);
    set_state(node, trial);
    buckets_[std::min(static_cast<std::size_t>(found / width_mm_), buckets_.size() - 1)].push_back(node);
  }

  void add_upwind(std::size_t node, int axis, typename Lattice<D>::Sides sides, UpwindEikonal<D>& eikonal) const {
    const std::ptrdiff_t stride = lattice_.stride[axis];
    const bool before = (sides & lattice_.before(axis)) && state_of(lattice_.moved(node, -stride)) >= known;
    const bool after = (sides & lattice_.after(axis)) && state_of(lattice_.moved(node, stride)) >= known;
    if (!before && !after) return;
    const std::ptrdiff_t step =
        before && (!after || sign_ * phi_[lattice_.moved(node, -stride)] <= sign_ * phi_[lattice_.moved(node, stride)])
            ? -stride
            : stride;
    const std::size_t next = lattice_.moved(node, step);
    const double h = lattice_.spacing_mm[axis], first = distance(next);
    if (sides_of(next) & (step < 0 ? lattice_.before(axis) : lattice_.after(axis))) {
      const std::size_t behind = lattice_.moved(next, step);
      // Across the curve every node of a pair is beside it.
      const bool is_known = !is_mine(behind) || state_of(behind) >= known;
      if (is_known && distance(behind) <= first) return eikonal.add(h, first, distance(behind));
    }
    eikonal.add(h, first);
  }

  float* const phi_;
  const Lattice<D>& lattice_;
  States& state_;
  const double band_mm_;
  const double sign_;
  const double width_mm_;
  std::vector<std::vector<std::size_t>> buckets_;  ///< trial nodes by distance; outdated entries are skipped
};

/// The states before marching.
template <int D>
States states_of(const Lattice<D>& lattice, std::size_t count, const std::vector<std::size_t>& beside) {
  States state(count, far);
  const std::size_t length = lattice.size[0];
  for (std::size_t first = 0; first < count; first += length) {
    const bool is_inner_line = length > 2 && lattice.sides_of(first + 1) == Lattice<D>::all_sides;
    if (is_inner_line)
      state[first] = state[first + length - 1] = border;
    else
      std::fill_n(state.begin() + static_cast<std::ptrdiff_t>(first), length, border);
  }
  for (const std::size_t node : beside) state[node] |= beside_curve;
  return state;
}

}  // namespace

template <int D>
void redistance(Field<D>& phi, double band_mm) {
  redistance(phi, band_mm, nodes_beside_curve(phi, Lattice<D>(phi)));
}

template <int D>
void redistance(Field<D>& phi, double band_mm, const std::vector<std::size_t>& beside) {
  const Lattice<D> lattice(phi);
  set_distances_beside_curve(phi, lattice, beside);
  States state = states_of(lattice, phi.values.size(), beside);
  Marcher<D> inner(phi, lattice, state, band_mm, true), outer(phi, lattice, state, band_mm, false);
  constexpr std::size_t worth_a_thread = 20000;
  if (beside.size() > worth_a_thread) {
    tbb::parallel_invoke([&] { inner.run(beside); }, [&] { outer.run(beside); });
  } else {
    inner.run(beside);
    outer.run(beside);
  }
  const auto band = static_cast<float>(band_mm);
  Pieces{phi.values.size(), 1 << 18}.for_each([&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t node = first; node < last; ++node) {
      float& value = phi.values[node];
      if ((state[node] & ~border) < known) value = is_inside(value) ? band : -band;
      value = std::clamp(value, -band, band);
    }
  });
}

template void redistance(Field<2>&, double);
template void redistance(Field<3>&, double);
template void redistance(Field<2>&, double, const std::vector<std::size_t>&);
template void redistance(Field<3>&, double, const std::vector<std::size_t>&);

}  // namespace isostack
