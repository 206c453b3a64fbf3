#include "recon/surface/zero_contours.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "recon/geometry/errors.h"
#include "recon/surface/root_finding.h"
#include "segmentation/trace_contours.h"

namespace isostack {

namespace {

constexpr double root_tolerance = 1e-6;  // of a lattice step

ScalarField in_space(const PlaneFunction& function) {
  return {.values = [&function](const Eigen::Matrix3Xd& points) { return function(points.topRows<2>()); },
          .gradients = {}};
}

Eigen::Vector3d lifted(const Eigen::Vector2d& point) { return {point.x(), point.y(), 0}; }

/// As an image for tracing: rounding must not turn a negative value into 0, which counts as inside.
Image<float> as_image(const PlaneLattice& lattice, const Eigen::VectorXd& values) {
  Image<float> image(lattice.size.y(), lattice.size.x());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const auto value = static_cast<float>(values[i]);
    image.data()[i] = values[i] < 0 ? std::min(value, -std::numeric_limits<float>::min()) : std::max(value, 0.0f);
  }
  return image;
}

/// A point of a traced curve with the step of the lattice it lies on.
struct Crossing {
  std::pair<std::size_t, std::size_t> at;  ///< curve, point
  CrossedSegment segment;
};

/// Curves in units of the lattice -> the lattice's steps they cross. Points beyond the rim are left as they are.
std::vector<Crossing> crossings_of(const std::vector<Contour>& traced, const PlaneLattice& lattice,
                                   const Eigen::VectorXd& values) {
  std::vector<Crossing> crossings;
  const auto value_at = [&](const Eigen::Vector2i& node) {
    return values[static_cast<Eigen::Index>(node.y()) * lattice.size.x() + node.x()];
  };
  const auto place = [&](const Eigen::Vector2i& node) {
    return lifted(lattice.first_mm + lattice.spacing_mm * node.cast<double>());
  };
  for (std::size_t c = 0; c < traced.size(); ++c)
    for (std::size_t p = 0; p < traced[c].points_mm.size(); ++p) {
      const Eigen::Vector2d& point = traced[c].points_mm[p];
      const Eigen::Vector2i from = point.array().floor().cast<int>();
      const Eigen::Vector2i to = point.array().ceil().cast<int>();
      if (from.minCoeff() < 0 || (to.array() >= lattice.size.array()).any()) continue;
      crossings.push_back({{c, p}, {place(from), place(to), value_at(from), value_at(to)}});
    }
  return crossings;
}

void move_to_roots(std::vector<Contour>& traced, const PlaneFunction& function, const PlaneLattice& lattice,
                   const Eigen::VectorXd& values) {
  const std::vector<Crossing> crossings = crossings_of(traced, lattice, values);
  for (Contour& contour : traced)
    for (Eigen::Vector2d& point : contour.points_mm) point = lattice.first_mm + lattice.spacing_mm * point;
  std::vector<CrossedSegment> segments;
  for (const Crossing& crossing : crossings) segments.push_back(crossing.segment);
  const std::vector<Eigen::Vector3d> roots = roots_on_segments(in_space(function), segments, root_tolerance);
  for (std::size_t i = 0; i < crossings.size(); ++i)
    traced[crossings[i].at.first].points_mm[crossings[i].at.second] = roots[i].head<2>();
}

/// The normal through the middle of a chord, from outside to inside, as far as the curve may bulge from it.
struct Normal {
  Eigen::Vector2d middle, inwards;  ///< inwards: as long as the chord
};

/// Where along the normal the function changes its sign: first near the chord, then, at tips and notches, farther on.
std::vector<std::optional<CrossedSegment>> crossed_normals(const std::vector<Normal>& normals,
                                                           const PlaneFunction& function) {
  constexpr std::array<double, 6> steps = {-2, -1, -0.5, 0.5, 1, 2};  // chords
  constexpr auto count = static_cast<Eigen::Index>(steps.size());
  Eigen::Matrix2Xd places(2, count * static_cast<Eigen::Index>(normals.size()));
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    const Normal& normal = normals[static_cast<std::size_t>(i / count)];
    places.col(i) = normal.middle + steps[static_cast<std::size_t>(i % count)] * normal.inwards;
  }
  const Eigen::VectorXd values = function(places);
  std::vector<std::optional<CrossedSegment>> crossed(normals.size());
  for (std::size_t n = 0; n < normals.size(); ++n)
    for (const Eigen::Index step : {2, 1, 3, 0, 4}) {  // from the chord outwards to either side
      const Eigen::Index from = static_cast<Eigen::Index>(n) * count + step;
      if (!(values[from] < 0 && values[from + 1] >= 0)) continue;
      crossed[n] =
          CrossedSegment{lifted(places.col(from)), lifted(places.col(from + 1)), values[from], values[from + 1]};
      break;
    }
  return crossed;
}

/// Puts a point on the curve into every chord it strays from; false when there was none.
class Refinement {
 public:
  Refinement(std::vector<Contour>& contours, const PlaneFunction& function, double deviation_mm)
      : contours_(contours), function_(function), deviation_mm_(deviation_mm) {
    for (const Contour& contour : contours) open_.emplace_back(contour.points_mm.size(), true);
  }

  bool once() {
    std::vector<Normal> normals;
    for (std::size_t c = 0; c < contours_.size(); ++c)
      for (std::size_t p = 0; p < open_[c].size(); ++p)
        if (open_[c][p]) normals.push_back(normal(c, p));
    if (normals.empty()) return false;
    std::vector<CrossedSegment> segments;
    std::vector<std::optional<std::size_t>> root_of;
    for (const std::optional<CrossedSegment>& crossed : crossed_normals(normals, function_)) {
      root_of.push_back(crossed ? std::optional(segments.size()) : std::nullopt);
      if (crossed) segments.push_back(*crossed);
    }
    insert(normals, root_of, roots_on_segments(in_space(function_), segments, root_tolerance));
    return true;
  }

 private:
  Normal normal(std::size_t c, std::size_t p) const {
    const auto& points = contours_[c].points_mm;
    const Eigen::Vector2d &a = points[p], &b = points[(p + 1) % points.size()];
    return {(a + b) / 2, {a.y() - b.y(), b.x() - a.x()}};
  }

  void insert(const std::vector<Normal>& normals, const std::vector<std::optional<std::size_t>>& root_of,
              const std::vector<Eigen::Vector3d>& roots) {
    std::size_t next = 0;
    for (std::size_t c = 0; c < contours_.size(); ++c) {
      std::vector<Eigen::Vector2d> points;
      std::vector<bool> open;
      for (std::size_t p = 0; p < open_[c].size(); ++p) {
        points.push_back(contours_[c].points_mm[p]);
        open.push_back(false);
        if (!open_[c][p]) continue;
        const Eigen::Vector2d middle = normals[next].middle;
        const std::optional<std::size_t> root = root_of[next++];
        if (!root) continue;
        const Eigen::Vector2d there = roots[*root].head<2>();
        if ((there - middle).norm() <= deviation_mm_) continue;
        points.push_back(there);
        open.back() = true;
        open.push_back(true);
      }
      contours_[c].points_mm = std::move(points);
      open_[c] = std::move(open);
    }
  }

  std::vector<Contour>& contours_;
  const PlaneFunction& function_;
  double deviation_mm_;
  std::vector<std::vector<bool>> open_;  ///< chords that may still stray from the curve
};

}  // namespace

PlaneLattice lattice_over(const Eigen::AlignedBox2d& box_mm, double spacing_mm) {
  const Eigen::Vector2d off_round = Eigen::Vector2d(0.381966, 0.414214) * spacing_mm;
  const Eigen::Array2d first = ((box_mm.min() - off_round).array() / spacing_mm).floor() - 2;
  const Eigen::Array2d last = ((box_mm.max() - off_round).array() / spacing_mm).ceil() + 2;
  const Eigen::Array2d size = last - first + 1;
  if (!(size.prod() <= 1e8))
    throw GeometryError("frame",
                        fmt::format("it has {:.0f} x {:.0f} steps of {:.3g} mm", size.x(), size.y(), spacing_mm),
                        "give a coarser resolution");
  return {.first_mm = first.matrix() * spacing_mm + off_round, .spacing_mm = spacing_mm, .size = size.cast<int>()};
}

Eigen::Matrix2Xd nodes_of(const PlaneLattice& lattice) {
  Eigen::Matrix2Xd nodes(2, static_cast<Eigen::Index>(lattice.size.x()) * lattice.size.y());
  Eigen::Index i = 0;
  for (int y = 0; y < lattice.size.y(); ++y)
    for (int x = 0; x < lattice.size.x(); ++x)
      nodes.col(i++) = lattice.first_mm + lattice.spacing_mm * Eigen::Vector2d(x, y);
  return nodes;
}

bool is_cut(const PlaneLattice& lattice, const Eigen::VectorXd& node_values) {
  return touches_border(as_image(lattice, node_values));
}

std::vector<Contour> zero_contours(const PlaneFunction& function, const PlaneLattice& lattice,
                                   const Eigen::VectorXd& node_values, double deviation_mm) {
  std::vector<Contour> contours = trace_contours(as_image(lattice, node_values), {1, 1});
  move_to_roots(contours, function, lattice, node_values);
  Refinement refinement(contours, function, deviation_mm);
  constexpr int most_halvings = 6;
  for (int halving = 0; halving < most_halvings && refinement.once(); ++halving) {
  }
  return contours;
}

}  // namespace isostack
