#include "recon/subdivision/loop_tiling.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t most_starts = 64;

/// Ways of edges from one edge to another, each the cheapest.
class Tiler {
 public:
  Tiler(const std::vector<Eigen::Vector2d>& lower, const std::vector<Eigen::Vector2d>& upper, const TilingRules& rules)
      : m_(static_cast<int>(lower.size())), n_(static_cast<int>(upper.size())) {
    const auto centre = [](const std::vector<Eigen::Vector2d>& loop) -> Eigen::Vector2d {
      return std::accumulate(loop.begin(), loop.end(), Eigen::Vector2d(0, 0)) / static_cast<double>(loop.size());
    };
    const Eigen::Vector2d shift = centre(upper) - centre(lower);
    cost_.resize(m_, n_);
    for (int i = 0; i < m_; ++i)
      for (int j = 0; j < n_; ++j) {
        const bool forbidden = rules.not_joined.contains({i, j});
        const Eigen::Vector2d way = upper[static_cast<std::size_t>(j)] - lower[static_cast<std::size_t>(i)] - shift;
        cost_(i, j) = forbidden ? infinite : way.squaredNorm();
      }
  }

  /// From edge (i, j) by `down` steps along the lower and `up` along the upper loop; without the last edge.
  std::vector<LoopPair> way(const LoopPair& from, int down, int up, double& cost) const {
    Eigen::MatrixXd best = Eigen::MatrixXd::Constant(down + 1, up + 1, infinite);
    for (int a = 0; a <= down; ++a)
      for (int b = 0; b <= up; ++b) {
        double before = a == 0 && b == 0 ? 0 : infinite;
        if (a > 0) before = std::min(before, best(a - 1, b));
        if (b > 0) before = std::min(before, best(a, b - 1));
        const bool is_end = a == down && b == up;  // the first edge once more, or that of the next way
        best(a, b) = before + (is_end ? 0 : cost_((from.first + a) % m_, (from.second + b) % n_));
      }
    cost = best(down, up);
    std::vector<LoopPair> result;
    for (int a = down, b = up; a > 0 || b > 0;) {
      const double left = a > 0 ? best(a - 1, b) : infinite, below = b > 0 ? best(a, b - 1) : infinite;
      if (b == 0 || (a > 0 && left <= below))
        --a;
      else
        --b;
      result.emplace_back((from.first + a) % m_, (from.second + b) % n_);
    }
    std::reverse(result.begin(), result.end());
    return result;
  }

  std::vector<LoopPair> from_near_edges() const {
    std::vector<int> starts(static_cast<std::size_t>(n_));
    std::iota(starts.begin(), starts.end(), 0);
    std::stable_sort(starts.begin(), starts.end(), [&](int a, int b) { return cost_(0, a) < cost_(0, b); });
    if (starts.size() > most_starts) starts.resize(most_starts);
    std::vector<LoopPair> result;
    double least = infinite;
    for (const int j : starts) {
      double cost = 0;
      std::vector<LoopPair> candidate = way({0, j}, m_, n_, cost);
      if (cost < least) {
        least = cost;
        result = std::move(candidate);
      }
    }
    return result;
  }

  std::vector<LoopPair> through(std::vector<LoopPair> joined) const {
    std::sort(joined.begin(), joined.end());
    joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
    std::vector<LoopPair> result;
    int all_down = 0, all_up = 0;
    for (std::size_t k = 0; k < joined.size(); ++k) {
      const LoopPair &here = joined[k], &next = joined[(k + 1) % joined.size()];
      int down = (next.first - here.first + m_) % m_, up = (next.second - here.second + n_) % n_;
      if (joined.size() == 1) {
        down = m_;
        up = n_;
      } else if (down == 0 && up == 0) {
        continue;
      }
      all_down += down;
      all_up += up;
      double cost = 0;
      const std::vector<LoopPair> part = way(here, down, up, cost);
      result.insert(result.end(), part.begin(), part.end());
    }
    if (all_down != m_ || all_up != n_)
      throw InputError("features", "the lines between two contours cross",
                       "name features in the same order round both contours");
    return result;
  }

 private:
  int m_, n_;
  Eigen::MatrixXd cost_;
};

}  // namespace

std::vector<LoopPair> tile_loops(const std::vector<Eigen::Vector2d>& lower, const std::vector<Eigen::Vector2d>& upper,
                                 const TilingRules& rules) {
  const Tiler tiler(lower, upper, rules);
  return rules.joined.empty() ? tiler.from_near_edges() : tiler.through(rules.joined);
}

}  // namespace isostack
