#include "recon/surface/root_finding.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace isostack {

namespace {

/// Bracket [low, high] in segment fractions with the (Illinois-weighted) values at its ends.
struct Bracket {
  double low = 0, high = 1;
  double low_value, high_value;
  double root = 0;
  int last_side = 0;
};

Eigen::Vector3d point_at(const CrossedSegment& segment, double fraction) {
  return segment.from_mm + fraction * (segment.to_mm - segment.from_mm);
}

double secant(const Bracket& b) {
  const double difference = b.low_value - b.high_value;
  const double fraction = difference != 0 ? b.low_value / difference : 0.5;
  return b.low + std::clamp(fraction, 0.0, 1.0) * (b.high - b.low);
}

/// Narrows the bracket by the value at its root; true when the next root is settled.
bool narrow(Bracket& b, double value, double tolerance) {
  const bool on_low_side = (value >= 0) == (b.low_value >= 0);
  if (on_low_side) {
    b.low = b.root, b.low_value = value;
    if (b.last_side == -1) b.high_value /= 2;
    b.last_side = -1;
  } else {
    b.high = b.root, b.high_value = value;
    if (b.last_side == 1) b.low_value /= 2;
    b.last_side = 1;
  }
  const double next = secant(b);
  const bool settled = value == 0 || std::abs(next - b.root) < tolerance || b.high - b.low < tolerance;
  if (value != 0) b.root = next;
  return settled;
}

}  // namespace

std::vector<Eigen::Vector3d> roots_on_segments(const ScalarField& field, const std::vector<CrossedSegment>& segments,
                                               double tolerance) {
  std::vector<Bracket> brackets;
  std::vector<std::size_t> open;
  for (const CrossedSegment& segment : segments) {
    Bracket bracket{.low_value = segment.from_value, .high_value = segment.to_value};
    bracket.root = secant(bracket);
    open.push_back(brackets.size());
    brackets.push_back(bracket);
  }
  for (int iteration = 0; iteration < 50 && !open.empty(); ++iteration) {
    Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(open.size()));
    for (std::size_t i = 0; i < open.size(); ++i)
      points.col(static_cast<Eigen::Index>(i)) = point_at(segments[open[i]], brackets[open[i]].root);
    const Eigen::VectorXd values = field.values(points);
    std::vector<std::size_t> still_open;
    for (std::size_t i = 0; i < open.size(); ++i)
      if (!narrow(brackets[open[i]], values[static_cast<Eigen::Index>(i)], tolerance)) still_open.push_back(open[i]);
    open = std::move(still_open);
  }
  std::vector<Eigen::Vector3d> roots;
  roots.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
    roots.push_back(point_at(segments[i], std::clamp(brackets[i].root, tolerance, 1 - tolerance)));
  return roots;
}

}  // namespace isostack
