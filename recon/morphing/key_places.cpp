#include "recon/morphing/key_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

Eigen::MatrixXd on_a_line(const std::vector<KeyShape>& shapes) {
  const auto timed = std::count_if(shapes.begin(), shapes.end(), [](const KeyShape& s) { return s.time.has_value(); });
  const auto count = static_cast<Eigen::Index>(shapes.size());
  if (timed == 0) return Eigen::RowVectorXd::LinSpaced(count, 0, static_cast<double>(count - 1));
  Eigen::RowVectorXd times(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const KeyShape& shape = shapes[static_cast<std::size_t>(i)];
    if (!shape.time || !std::isfinite(*shape.time))
      throw InputError(shape.name, "it has no time, but another shape has one", "give every shape a time, or none");
    if (i > 0 && !(*shape.time > times[i - 1]))
      throw InputError(shape.name,
                       fmt::format("its time {} is not after the shape before it at {}", *shape.time, times[i - 1]),
                       "give times that ascend");
    times[i] = *shape.time;
  }
  return (times.array() - times[0]) * (static_cast<double>(count - 1) / (times[count - 1] - times[0]));
}

/// Corners of a regular simplex with edge 1: each new corner above the middle of those before it.
Eigen::MatrixXd on_a_simplex(Eigen::Index count) {
  Eigen::MatrixXd corners = Eigen::MatrixXd::Zero(count - 1, count);
  for (Eigen::Index k = 1; k < count; ++k) {
    corners.col(k) = corners.leftCols(k).rowwise().mean();
    corners(k - 1, k) = std::sqrt(1 - (corners.col(k) - corners.col(0)).squaredNorm());
  }
  return corners;
}

Eigen::MatrixXd as_given(const std::vector<KeyShape>& shapes) {
  const Eigen::Index dimensions = shapes.front().place.size();
  Eigen::MatrixXd places(dimensions, static_cast<Eigen::Index>(shapes.size()));
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes[i].place.size() == 0 || shapes[i].place.size() != dimensions || !shapes[i].place.allFinite())
      throw InputError(shapes[i].name, "its place does not have as many coordinates as the first shape's",
                       "give every shape a place with the same number of coordinates");
    for (std::size_t j = 0; j < i; ++j)
      if ((shapes[i].place - shapes[j].place).norm() < 1e-9)
        throw InputError(shapes[i].name, fmt::format("it is at the same place as {}", shapes[j].name),
                         "give every shape a place of its own");
    places.col(static_cast<Eigen::Index>(i)) = shapes[i].place;
  }
  return places;
}

}  // namespace

KeyPlaces key_places(const std::vector<KeyShape>& shapes, KeyLayout layout) {
  if (shapes.size() < 2) throw InputError("morph", "a morph needs two shapes or more", "give another shape");
  switch (layout) {
    case KeyLayout::line:
      return {layout, on_a_line(shapes)};
    case KeyLayout::simplex:
      return {layout, on_a_simplex(static_cast<Eigen::Index>(shapes.size()))};
    case KeyLayout::given:
      return {layout, as_given(shapes)};
  }
  return {};
}

Eigen::VectorXd KeyPlaces::weights_at(double t) const {
  if (!(t >= 0 && t <= 1)) throw InputError("morph", fmt::format("t = {} is not between 0 and 1", t), "give 0 … 1");
  const Eigen::Index count = key_count();
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(count);
  if (layout != KeyLayout::line) {
    weights[0] = 1 - t;
    weights[count - 1] += t;
    return weights;
  }
  const auto at = [&](Eigen::Index i) { return coordinates(0, i); };
  const double place = at(0) + t * (at(count - 1) - at(0));
  Eigen::Index before = 0;
  while (before + 2 < count && at(before + 1) <= place) ++before;
  const double share = std::clamp((place - at(before)) / (at(before + 1) - at(before)), 0.0, 1.0);
  weights[before] = 1 - share;
  weights[before + 1] = share;
  return weights;
}

void KeyPlaces::require_weights(const Eigen::VectorXd& weights) const {
  constexpr double rounding = 1e-6;  // of weights written with seven digits
  if (weights.size() != key_count())
    throw InputError("place", fmt::format("{} weights for {} shapes", weights.size(), key_count()),
                     "give one weight for each shape");
  if (!weights.allFinite() || weights.minCoeff() < -rounding || std::abs(weights.sum() - 1) > rounding)
    throw InputError("place", "its weights are not at least 0 with the sum 1", "divide them by their sum");
}

std::vector<Eigen::VectorXd> weights_along_path(const std::vector<Eigen::VectorXd>& corners, std::size_t count) {
  if (corners.size() < 2 || count < 2)
    throw InputError("path", "it has fewer than two corners or frames", "give two or more of each");
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (corners[i].size() != corners[0].size())
      throw InputError("path", "its corners have different numbers of weights", "give one weight for each shape");
    lengths.push_back(lengths.back() + (corners[i] - corners[i - 1]).norm());
  }
  if (!(lengths.back() > 0)) throw InputError("path", "all its corners are the same", "give different corners");
  std::vector<Eigen::VectorXd> path;
  for (std::size_t i = 0; i < count; ++i) {
    const double length = lengths.back() * static_cast<double>(i) / static_cast<double>(count - 1);
    const auto next = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, length);
    const auto to = static_cast<std::size_t>(next - lengths.begin());
    const double edge = lengths[to] - lengths[to - 1];
    const double share = edge > 0 ? std::clamp((length - lengths[to - 1]) / edge, 0.0, 1.0) : 1;
    path.push_back(corners[to - 1] + share * (corners[to] - corners[to - 1]));
  }
  return path;
}

}  // namespace isostack
