#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace isostack {

/// Godunov's upwind discretisation of |∇u| = 1 (Breen et al. 2001, eq. 7) at one node, u >= 0 the distance to the
/// curve: Σ_axis (slope·u − offset)² = 1 over the axes from whose neighbour information comes.
template <int D>
class UpwindEikonal {
 public:
  /// The neighbour at distance `h` along an axis has the smaller distance `first`.
  void add(double h, double first) { insert({1 / h, first / h, first}); }
  /// The one behind it has `second` <= `first`: second order.
  void add(double h, double first, double second) { insert({1.5 / h, (2 * first - 0.5 * second) / h, first}); }

  /// u; infinite without any neighbour.
  double solve() {
    // An axis whose neighbour is farther than the solution is not upwind: solve again without it.
    for (; count_ > 0; --count_) {
      double a = 0, b = 0, c = -1;
      for (int i = 0; i < count_; ++i) {
        const Difference& d = used_[static_cast<std::size_t>(i)];
        a += d.slope * d.slope;
        b += d.slope * d.offset;
        c += d.offset * d.offset;
      }
      const double discriminant = b * b - a * c;
      if (discriminant < 0) continue;
      const double distance = (b + std::sqrt(discriminant)) / a;
      if (distance >= used_[static_cast<std::size_t>(count_ - 1)].neighbour) return distance;
    }
    return std::numeric_limits<double>::infinity();
  }

 private:
  struct Difference {
    double slope, offset, neighbour;
  };

  void insert(const Difference& difference) {  // ascending by neighbour
    int at = count_++;
    for (; at > 0 && used_[static_cast<std::size_t>(at - 1)].neighbour > difference.neighbour; --at)
      used_[static_cast<std::size_t>(at)] = used_[static_cast<std::size_t>(at - 1)];
    used_[static_cast<std::size_t>(at)] = difference;
  }

  std::array<Difference, D> used_;
  int count_ = 0;
};

}  // namespace isostack
