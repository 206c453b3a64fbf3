#include "recon/subdivision/pinched_loops.h"

#include <fmt/format.h>

#include <cstdlib>
#include <limits>
#include <set>
#include <tuple>

#include "recon/geometry/errors.h"

namespace isostack {

std::vector<std::vector<int>> PinchedLoops::loops(const std::vector<bool>& switched) const {
  std::vector<int> after = next;
  for (std::size_t p = 0; p < pinches.size(); ++p)
    if (switched[p])
      std::swap(after[static_cast<std::size_t>(pinches[p].first)], after[static_cast<std::size_t>(pinches[p].second)]);
  std::vector<std::vector<int>> result;
  std::vector<bool> seen(after.size(), false);
  for (std::size_t start = 0; start < after.size(); ++start) {
    if (seen[start]) continue;
    result.emplace_back();
    for (std::size_t at = start; !seen[at]; at = static_cast<std::size_t>(after[at])) {
      seen[at] = true;
      result.back().push_back(static_cast<int>(at));
    }
  }
  return result;
}

double PinchedLoops::signed_area_mm2(const std::vector<int>& loop) const {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d& a = places_mm[static_cast<std::size_t>(loop[i])];
    const Eigen::Vector2d& b = places_mm[static_cast<std::size_t>(loop[(i + 1) % loop.size()])];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

LoopCount PinchedLoops::count(const std::vector<bool>& switched) const {
  LoopCount result;
  for (const std::vector<int>& loop : loops(switched)) ++(signed_area_mm2(loop) > 0 ? result.outer : result.holes);
  return result;
}

void PinchedLoops::add(const std::vector<Eigen::Vector2d>& loop) {
  const auto first = static_cast<int>(places_mm.size()), count = static_cast<int>(loop.size());
  for (int i = 0; i < count; ++i) {
    places_mm.push_back(loop[static_cast<std::size_t>(i)]);
    next.push_back(first + (i + 1) % count);
  }
}

PinchedLoops pinched_loops(const std::vector<std::vector<Eigen::Vector2d>>& loops, double tolerance_mm) {
  PinchedLoops result;
  for (const auto& loop : loops) result.add(loop);
  std::set<int> taken;
  for (int a = 0; a < static_cast<int>(result.next.size()); ++a)
    for (int b = a + 1; b < static_cast<int>(result.next.size()); ++b) {
      const bool neighbours =
          result.next[static_cast<std::size_t>(a)] == b || result.next[static_cast<std::size_t>(b)] == a;
      const Eigen::Vector2d& place = result.places_mm[static_cast<std::size_t>(a)];
      if (neighbours || (place - result.places_mm[static_cast<std::size_t>(b)]).norm() > tolerance_mm) continue;
      if (!taken.insert(a).second || !taken.insert(b).second)
        throw InputError("key shape",
                         fmt::format("more than two curves meet at ({:.4g}, {:.4g})", place.x(), place.y()),
                         "let two curves meet in a point");
      result.pinches.emplace_back(a, b);
    }
  return result;
}

PinchedLoops tied_together(const std::vector<std::vector<Eigen::Vector2d>>& loops) {
  PinchedLoops result;
  std::vector<int> loop_of;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    result.add(loops[i]);
    loop_of.resize(result.next.size(), static_cast<int>(i));
  }
  std::set<int> tied = {0}, taken;
  while (tied.size() < loops.size()) {
    double least = std::numeric_limits<double>::infinity();
    std::pair<int, int> nearest;
    for (int a = 0; a < static_cast<int>(loop_of.size()); ++a)
      for (int b = 0; b < static_cast<int>(loop_of.size()); ++b) {
        const auto ia = static_cast<std::size_t>(a), ib = static_cast<std::size_t>(b);
        if (!tied.contains(loop_of[ia]) || tied.contains(loop_of[ib]) || taken.contains(a)) continue;
        const double distance = (result.places_mm[ia] - result.places_mm[ib]).norm();
        if (distance < least) std::tie(least, nearest) = std::tuple(distance, std::pair(a, b));
      }
    Eigen::Vector2d& from = result.places_mm[static_cast<std::size_t>(nearest.first)];
    Eigen::Vector2d& to = result.places_mm[static_cast<std::size_t>(nearest.second)];
    from = to = ((from + to) / 2).eval();
    result.pinches.push_back(nearest);
    taken.insert({nearest.first, nearest.second});
    tied.insert(loop_of[static_cast<std::size_t>(nearest.second)]);
  }
  return result;
}

std::vector<bool> switched_for(const PinchedLoops& loops, const LoopCount& wanted) {
  constexpr std::size_t most = 12;
  const std::size_t count = loops.pinches.size();
  if (count > most)
    throw InputError("key shape", fmt::format("its curves meet in {} points", count), "let them meet in 12 or fewer");
  std::vector<bool> best;
  std::tuple<int, int> least(std::numeric_limits<int>::max(), 0);
  for (unsigned mask = 0; mask < (1U << count); ++mask) {
    std::vector<bool> switched(count);
    int switches = 0;
    for (std::size_t p = 0; p < count; ++p) switches += (switched[p] = ((mask >> p) & 1U) != 0) ? 1 : 0;
    const LoopCount found = loops.count(switched);
    const std::tuple badness(std::abs(found.outer - wanted.outer) + std::abs(found.holes - wanted.holes), switches);
    if (badness < least) {
      least = badness;
      best = switched;
    }
  }
  return best;
}

}  // namespace isostack
