#include "recon/solvers/coarse_to_fine.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/solvers/box_tree.h"

namespace isostack {

namespace {

constexpr std::size_t few_points = 64;  ///< not thinned any further

/// A fixed random-looking rank per point: thinning by it leaves evenly spread points.
std::uint64_t shuffled_rank(std::uint64_t index) {
  index += 0x9e3779b97f4a7c15ULL;
  index = (index ^ index >> 30) * 0xbf58476d1ce4e5b9ULL;
  index = (index ^ index >> 27) * 0x94d049bb133111ebULL;
  return index ^ index >> 31;
}

/// Ranks of which the higher survive; those of the first points are the highest.
std::vector<std::uint64_t> ranks_of(std::size_t count, const std::vector<std::uint32_t>& first) {
  std::vector<std::uint64_t> ranks(count);
  for (std::size_t i = 0; i < count; ++i) ranks[i] = shuffled_rank(i) >> 1;
  for (std::size_t k = 0; k < first.size(); ++k) ranks[first[k]] = std::numeric_limits<std::uint64_t>::max() - k;
  return ranks;
}

/// The points of one level: indices into all points, and their search tree.
struct Survivors {
  std::vector<std::uint32_t> points;
  BoxTree tree;
  std::vector<std::uint64_t> ranks;

  Survivors(const Eigen::MatrixXd& all, std::vector<std::uint32_t> chosen, const std::vector<std::uint64_t>& all_ranks)
      : points(std::move(chosen)), tree(columns(all, points)) {
    for (const std::uint32_t i : points) ranks.push_back(all_ranks[i]);
  }
  std::size_t size() const { return points.size(); }

 private:
  static Eigen::MatrixXd columns(const Eigen::MatrixXd& all, const std::vector<std::uint32_t>& chosen) {
    Eigen::MatrixXd result(all.rows(), static_cast<Eigen::Index>(chosen.size()));
    tbb::parallel_for(std::size_t{0}, chosen.size(),
                      [&](std::size_t k) { result.col(static_cast<Eigen::Index>(k)) = all.col(chosen[k]); });
    return result;
  }
};

/// A radius at which the thinning of the finest level starts to bite: one in twenty points has a
/// neighbour closer than that.
double first_radius(const Survivors& all, double extent) {
  if (all.size() < 2) return 1;
  const std::size_t samples = std::min<std::size_t>(all.size(), 1000);
  std::vector<double> nearest(samples);
  tbb::parallel_for(std::size_t{0}, samples, [&](std::size_t s) {
    const auto i = static_cast<Eigen::Index>(s * all.size() / samples);
    std::vector<BoxTree::Neighbour> found;
    for (double radius = extent * 1e-6; found.empty(); radius *= 2)
      all.tree.within(all.tree.points().col(i), radius, found, [&](std::uint32_t j) { return j != i; });
    nearest[s] = std::sqrt(std::min_element(found.begin(), found.end())->squared_distance);
  });
  std::sort(nearest.begin(), nearest.end());
  return nearest[samples / 20] * 1.001;
}

/// Which points stay when, in the order of rank, every point removes those within `radius`. Rounds of
/// decisions that cannot be contested give the same result as that sequence.
std::vector<char> thin(const Survivors& level, double radius) {
  enum : char { open, kept, removed };
  const std::size_t count = level.size();
  std::vector<std::vector<std::uint32_t>> stronger(count);  // neighbours that would remove it
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    thread_local std::vector<BoxTree::Neighbour> found;
    found.clear();
    level.tree.within(level.tree.points().col(static_cast<Eigen::Index>(i)), radius, found,
                      [&](std::uint32_t j) { return level.ranks[j] > level.ranks[i]; });
    for (const BoxTree::Neighbour& neighbour : found) stronger[i].push_back(neighbour.index);
  });
  std::vector<char> state(count, open);
  for (std::vector<std::uint32_t> undecided =
           [&] {
             std::vector<std::uint32_t> every(count);
             for (std::size_t i = 0; i < count; ++i) every[i] = static_cast<std::uint32_t>(i);
             return every;
           }();
       !undecided.empty();) {
    std::vector<char> decision(undecided.size(), open);
    tbb::parallel_for(std::size_t{0}, undecided.size(), [&](std::size_t k) {
      bool contested = false;
      for (const std::uint32_t j : stronger[undecided[k]]) {
        if (state[j] == kept) {
          decision[k] = removed;
          return;
        }
        contested = contested || state[j] == open;
      }
      if (!contested) decision[k] = kept;
    });
    std::vector<std::uint32_t> left;
    for (std::size_t k = 0; k < undecided.size(); ++k) {
      state[undecided[k]] = decision[k];
      if (decision[k] == open) left.push_back(undecided[k]);
    }
    undecided = std::move(left);
  }
  for (char& s : state) s = s == kept;
  return state;
}

/// The k nearest points of a level that precede `i`: survivors of the next level, or higher in rank.
void nearest_predecessors(const Survivors& level, const std::vector<char>& stays, std::uint32_t i, std::size_t k,
                          double& radius, std::vector<BoxTree::Neighbour>& found) {
  const auto precedes = [&](std::uint32_t j) { return stays[j] || level.ranks[j] > level.ranks[i]; };
  const auto centre = level.tree.points().col(i);
  for (;; radius *= 1.3) {
    found.clear();
    level.tree.within(centre, radius, found, precedes);
    if (found.size() >= k) break;
  }
  if (found.size() > k) {
    std::nth_element(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(k), found.end());
    found.resize(k);
  }
  std::sort(found.begin(), found.end());
  if (found.empty()) return;
  // What would have been enough, with a little room, is the guess for the next point close by.
  radius = std::min(radius, 1.1 * std::sqrt(found.back().squared_distance));
}

CoarseToFine::Level neighbours_of(const Survivors& level, const std::vector<char>& stays, std::size_t k,
                                  double extent) {
  CoarseToFine::Level result;
  std::vector<std::uint32_t> local;
  for (std::uint32_t i = 0; i < level.size(); ++i)
    if (!stays[i]) local.push_back(i);
  std::size_t stay_count = level.size() - local.size();
  // In a level of few points the predecessors may be fewer than k.
  std::vector<std::uint32_t> by_rank = local;
  std::sort(by_rank.begin(), by_rank.end(), [&](auto a, auto b) { return level.ranks[a] > level.ranks[b]; });
  std::vector<std::size_t> wanted(level.size());
  for (const std::uint32_t i : by_rank) wanted[i] = std::min(k, stay_count++);

  result.begin.assign(local.size() + 1, 0);
  for (std::size_t q = 0; q < local.size(); ++q) {
    result.points.push_back(level.points[local[q]]);
    result.begin[q + 1] = result.begin[q] + wanted[local[q]];
  }
  result.predecessors.resize(result.begin.back());
  constexpr std::size_t chunk = 64;
  tbb::parallel_for(std::size_t{0}, (local.size() + chunk - 1) / chunk, [&](std::size_t c) {
    std::vector<BoxTree::Neighbour> found;
    double radius = extent * std::sqrt(static_cast<double>(k) / static_cast<double>(level.size()));
    for (std::size_t q = c * chunk; q < std::min(local.size(), (c + 1) * chunk); ++q) {
      nearest_predecessors(level, stays, local[q], wanted[local[q]], radius, found);
      for (std::size_t n = 0; n < found.size(); ++n)
        result.predecessors[result.begin[q] + n] = level.points[found[n].index];
    }
  });
  return result;
}

}  // namespace

CoarseToFine order_coarse_to_fine(const Eigen::MatrixXd& points, const std::vector<std::uint32_t>& first,
                                  const CoarseToFineOptions& options, const Progress& progress) {
  const auto count = static_cast<std::size_t>(points.cols());
  const double extent = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
  const std::vector<std::uint64_t> ranks = ranks_of(count, first);
  std::vector<std::uint32_t> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = static_cast<std::uint32_t>(i);
  Survivors level(points, std::move(all), ranks);

  CoarseToFine result;
  for (double radius = first_radius(level, extent); level.size() > first.size(); radius /= options.radius_ratio) {
    std::vector<char> stays;
    if (level.size() > std::max(few_points, 2 * first.size())) {
      stays = thin(level, radius);
      if (std::find(stays.begin(), stays.end(), 0) == stays.end()) continue;
    } else {
      for (const std::uint64_t rank : level.ranks)
        stays.push_back(rank > std::numeric_limits<std::uint64_t>::max() / 2);
    }
    const double share = static_cast<double>(level.size()) / static_cast<double>(count);
    const double k =
        std::min<double>(options.most_neighbours, options.neighbours * std::pow(share, -options.neighbour_growth));
    result.levels.push_back(neighbours_of(level, stays, static_cast<std::size_t>(k), extent));
    std::vector<std::uint32_t> next;
    for (std::size_t i = 0; i < level.size(); ++i)
      if (stays[i]) next.push_back(level.points[i]);
    level = Survivors(points, std::move(next), ranks);
    progress.report("order", 1 - static_cast<double>(level.size()) / static_cast<double>(count));
  }
  return result;
}

}  // namespace isostack
