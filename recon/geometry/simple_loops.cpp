#include "recon/geometry/simple_loops.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "recon/geometry/disjoint_sets.h"
#include "recon/geometry/loop_edges.h"

namespace isostack {

namespace {

using PointPair = std::pair<int, int>;  ///< the smaller number first

/// How often each curve runs along a piece, odd or even, is all that matters for what it encloses.
std::map<PointPair, std::vector<int>> loops_along(const LoopEdges& edges) {
  std::map<PointPair, std::vector<int>> loops;
  for (const LoopEdge& edge : edges.edges()) {
    std::vector<int>& here = loops[std::minmax(edge.from, edge.to)];
    const auto same = std::find(here.begin(), here.end(), edge.loop);
    if (same == here.end())
      here.push_back(edge.loop);
    else
      here.erase(same);
  }
  std::erase_if(loops, [](const auto& entry) { return entry.second.empty(); });
  return loops;
}

bool is_inside(const std::vector<char>& in_loop, InsideRule rule) {
  const auto count = std::count(in_loop.begin(), in_loop.end(), 1);
  return rule == InsideRule::any ? count > 0 : count % 2 == 1;
}

/// Pieces with the inside on one side only, directed so that it is to the left.
class Boundary {
 public:
  Boundary(const LoopEdges& edges, std::size_t loop_count, InsideRule rule)
      : edges_(edges), loops_(loops_along(edges)), loop_count_(loop_count), rule_(rule) {
    for (int axis = 0; axis < 2; ++axis) fill_bands(axis);
    for (const auto& [piece, loops] : loops_) add_if_boundary(piece, loops);
  }

  /// Loops of points; each visits no point twice.
  std::vector<Contour> trace() {
    std::vector<Contour> found;
    for (auto& [start, ends] : from_)
      while (!ends.empty()) walk(start, found);
    return found;
  }

 private:
  using Piece = std::map<PointPair, std::vector<int>>::value_type;

  /// Pieces that a ray along an axis may cross, by where the ray lies across it.
  struct Bands {
    double low = 0, width = 1;
    std::vector<std::vector<const Piece*>> pieces = {{}};
    std::size_t at(double place) const {
      return static_cast<std::size_t>(std::clamp((place - low) / width, 0.0, static_cast<double>(pieces.size() - 1)));
    }
  };

  void fill_bands(int axis) {
    Bands& bands = bands_[axis];
    const int other = 1 - axis;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Piece& piece : loops_)
      for (const int point : {piece.first.first, piece.first.second}) {
        low = std::min(low, edges_.at(point)[other]);
        high = std::max(high, edges_.at(point)[other]);
      }
    if (!(high > low)) return;
    constexpr std::size_t most_bands = 512;  // bounds memory where every piece crosses all of them
    bands.pieces.resize(std::clamp<std::size_t>(loops_.size() / 4, 1, most_bands));
    bands.low = low;
    bands.width = (high - low) / static_cast<double>(bands.pieces.size());
    for (const Piece& piece : loops_) {
      const double a = edges_.at(piece.first.first)[other], b = edges_.at(piece.first.second)[other];
      for (std::size_t i = bands.at(std::min(a, b)); i <= bands.at(std::max(a, b)); ++i)
        bands.pieces[i].push_back(&piece);
    }
  }

  void add_if_boundary(const PointPair& piece, const std::vector<int>& loops) {
    // Towards a ray's start at the middle of the piece, across the axis along which the piece is longer.
    const Eigen::Vector2d along = edges_.at(piece.second) - edges_.at(piece.first);
    const int axis = std::abs(along.y()) >= std::abs(along.x()) ? 0 : 1;
    std::vector<char> beyond = loops_crossed(piece, axis);
    const bool inside_beyond = is_inside(beyond, rule_);
    for (const int loop : loops) beyond[static_cast<std::size_t>(loop)] ^= 1;
    if (is_inside(beyond, rule_) == inside_beyond) return;
    // The ray leaves to the left when it turns counter-clockwise from the piece.
    const double turn = axis == 0 ? -along.y() : along.x();
    const bool forwards = (turn > 0) == inside_beyond;
    const int from = forwards ? piece.first : piece.second;
    from_[from].push_back(forwards ? piece.second : piece.first);
    ++pieces_at_[from];
  }

  /// For each curve whether a point next to the piece, on the side of growing coordinate `axis`, lies within.
  std::vector<char> loops_crossed(const PointPair& piece, int axis) const {
    std::vector<char> inside(loop_count_, 0);
    const Eigen::Vector2d start = (edges_.at(piece.first) + edges_.at(piece.second)) / 2;
    const int other = 1 - axis;
    for (const Piece* crossed : bands_[axis].pieces[bands_[axis].at(start[other])]) {
      const auto& [ends, loops] = *crossed;
      if (ends == piece) continue;
      const Eigen::Vector2d &a = edges_.at(ends.first), &b = edges_.at(ends.second);
      if ((a[other] > start[other]) == (b[other] > start[other])) continue;
      const double crossing = a[axis] + (start[other] - a[other]) / (b[other] - a[other]) * (b[axis] - a[axis]);
      if (crossing > start[axis])
        for (const int loop : loops) inside[static_cast<std::size_t>(loop)] ^= 1;
    }
    return inside;
  }

  /// The way on that keeps the inside together: the first one clockwise from where we came.
  int take_next(int previous, int point) {
    std::vector<int>& ends = from_[point];
    const Eigen::Vector2d back = previous < 0 ? Eigen::Vector2d(1, 0) : (edges_.at(previous) - edges_.at(point)).eval();
    const auto clockwise_turn = [&](int end) {
      const Eigen::Vector2d ahead = edges_.at(end) - edges_.at(point);
      const double angle = std::atan2(ahead.x() * back.y() - ahead.y() * back.x(), ahead.dot(back));
      return angle > 0 ? angle : angle + 2 * M_PI;
    };
    const auto best =
        std::min_element(ends.begin(), ends.end(), [&](int a, int b) { return clockwise_turn(a) < clockwise_turn(b); });
    const int end = *best;
    ends.erase(best);
    return end;
  }

  void walk(int start, std::vector<Contour>& found) {
    std::vector<int> path = {start};
    std::map<int, std::size_t> place_in_path = {{start, 0}};
    for (int point = start; !from_[point].empty();) {
      point = take_next(path.size() > 1 ? path[path.size() - 2] : -1, point);
      const auto [place, is_new] = place_in_path.try_emplace(point, path.size());
      if (!is_new) {
        const std::size_t begin = place->second;
        close(std::vector<int>(path.begin() + static_cast<std::ptrdiff_t>(begin), path.end()), found);
        for (std::size_t i = begin + 1; i < path.size(); ++i) place_in_path.erase(path[i]);
        path.resize(begin);
      }
      path.push_back(point);
    }
  }

  void close(std::vector<int> points, std::vector<Contour>& found) const {
    if (points.size() < 3) return;
    // Nesting is told by the first point, which therefore must not be one where curves touch.
    const auto plain = std::find_if(points.begin(), points.end(), [&](int point) { return pieces_at_.at(point) == 1; });
    if (plain != points.end()) std::rotate(points.begin(), plain, points.end());
    Contour& contour = found.emplace_back();
    for (const int point : points) contour.points_mm.push_back(edges_.at(point));
  }

  const LoopEdges& edges_;
  std::map<PointPair, std::vector<int>> loops_;
  Bands bands_[2];  ///< for rays along x and y
  std::size_t loop_count_;
  InsideRule rule_;
  std::map<int, std::vector<int>> from_;
  std::map<int, int> pieces_at_;  ///< how many leave a point
};

std::vector<Contour> resolved(const std::vector<Contour>& contours, InsideRule rule, double tolerance_mm) {
  LoopEdges edges(contours, tolerance_mm);
  edges.cut_where_they_meet();
  std::vector<Contour> loops = Boundary(edges, contours.size(), rule).trace();
  std::erase_if(
      loops, [&](const Contour& contour) { return std::abs(signed_area_mm2(contour)) < tolerance_mm * tolerance_mm; });
  return loops;
}

/// For each curve the number of its group; -1 for curves that meet none, not even themselves.
std::vector<int> groups_of(const std::vector<Contour>& contours, InsideRule rule, double tolerance_mm) {
  std::vector<int> group(contours.size(), -1);
  if (rule == InsideRule::any && contours.size() > 1) {
    std::fill(group.begin(), group.end(), 0);
    return group;
  }
  DisjointSets sets(contours.size());
  const auto meetings = LoopEdges(contours, tolerance_mm).meetings();
  for (const auto& [a, b] : meetings) sets.join(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
  for (const auto& [a, b] : meetings)
    for (const int loop : {a, b})
      group[static_cast<std::size_t>(loop)] = static_cast<int>(sets.root(static_cast<std::size_t>(loop)));
  return group;
}

}  // namespace

std::vector<Contour> simple_loops(const std::vector<Contour>& contours, InsideRule rule, double tolerance_mm) {
  const std::vector<int> group = groups_of(contours, rule, tolerance_mm);
  std::map<int, std::vector<Contour>> touching;
  std::vector<Contour> simple;
  for (std::size_t i = 0; i < contours.size(); ++i) (group[i] < 0 ? simple : touching[group[i]]).push_back(contours[i]);
  for (const auto& [number, together] : touching) {
    std::vector<Contour> loops = resolved(together, rule, tolerance_mm);
    std::move(loops.begin(), loops.end(), std::back_inserter(simple));
  }
  orient_by_nesting(simple);
  return simple;
}

}  // namespace isostack
