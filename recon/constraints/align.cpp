#include "recon/constraints/align.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace isostack {

namespace {

/// What the solve moves: where each slice is now, about which point it turns, how far its contours reach.
struct MovingSlices {
  const ContourStack& original;
  ContourStack stack;
  std::vector<InPlaneMotion> motions;
  std::vector<Eigen::Vector2d> centres_mm;  ///< slice coordinates
  std::vector<double> reach_mm;             ///< rms distance of the contours' points from there
  bool rotation;

  int unknowns() const { return rotation ? 3 : 2; }
};

MovingSlices at_rest(const ContourStack& stack, bool rotation) {
  const std::size_t count = stack.slices.size();
  MovingSlices moving{stack, stack, std::vector<InPlaneMotion>(count), {}, {}, rotation};
  for (const ContourSlice& slice : stack.slices) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double points = 0, squares = 0;
    for (const Contour& contour : slice.contours)
      for (const Eigen::Vector2d& p : contour.points_mm) sum += p, points += 1;
    const Eigen::Vector2d centre = points > 0 ? Eigen::Vector2d(sum / points) : sum;
    for (const Contour& contour : slice.contours)
      for (const Eigen::Vector2d& p : contour.points_mm) squares += (p - centre).squaredNorm();
    moving.centres_mm.push_back(centre);
    moving.reach_mm.push_back(points > 0 ? std::sqrt(squares / points) : 1);
  }
  return moving;
}

/// One mismatch, and how it changes with the motions of the slices concerned.
struct Equation {
  struct Term {
    std::size_t slice;
    Eigen::Vector3d gradient;  ///< per shift x, shift y (mm) and arc (rotation × reach, mm)
  };
  double mismatch_mm = 0;
  std::vector<Term> terms;
};

/// The change of a quantity whose gradient by displacement of the contour at `point_mm` is `by_displacement`.
Equation::Term term_for(const MovingSlices& moving, std::size_t slice, const Eigen::Vector3d& point_mm,
                        const Eigen::Vector3d& by_displacement) {
  const SlicePose& was = moving.original.slices[slice].pose;
  const SlicePose& now = moving.stack.slices[slice].pose;
  const Eigen::Vector3d arm = point_mm - now.slice_to_world(moving.centres_mm[slice]);
  const double by_turn = by_displacement.dot(now.normal().cross(arm));
  return {slice, {by_displacement.dot(was.x_axis), by_displacement.dot(was.y_axis), by_turn / moving.reach_mm[slice]}};
}

/// Two versions of one crossing: they shall meet. The line's places are weighted by the flatter contour's
/// angle, so that a line grazing a contour does not count for more than the contours are apart.
Equation matched_equation(const MovingSlices& moving, const SlicePair& pair, const Contradiction& place) {
  const Eigen::Vector3d along = (place.ends[1].point_mm - place.ends[0].point_mm).normalized();
  const double steepness =
      std::min(std::abs(place.ends[0].inward.dot(along)), std::abs(place.ends[1].inward.dot(along)));
  Equation equation{.mismatch_mm = steepness * place.length_mm, .terms = {}};
  for (int end = 0; end < 2; ++end) {
    const Contradiction::End& e = place.ends[static_cast<std::size_t>(end)];
    const double sign = end == 0 ? -1 : 1;
    equation.terms.push_back(term_for(moving, e.of_first ? pair.first : pair.second, e.point_mm,
                                      sign * steepness / e.inward.dot(along) * e.inward));
  }
  return equation;
}

/// Gradient of the signed distance within the slice, world frame.
Eigen::Vector3d distance_gradient(const ContourSlice& slice, const Eigen::Vector2d& point) {
  constexpr double step_mm = 1e-4;
  const auto slope = [&](const Eigen::Vector2d& axis) {
    return (signed_distance_mm(slice.contours, point + step_mm * axis) -
            signed_distance_mm(slice.contours, point - step_mm * axis)) /
           (2 * step_mm);
  };
  return slope(Eigen::Vector2d::UnitX()) * slice.pose.x_axis + slope(Eigen::Vector2d::UnitY()) * slice.pose.y_axis;
}

/// One slice misses a stretch: the contour that is nearer to the stretch's middle shall come to it.
Equation missing_equation(const MovingSlices& moving, const SlicePair& pair, const Contradiction& place) {
  Equation equation;
  equation.mismatch_mm = std::numeric_limits<double>::infinity();
  for (const std::size_t index : {pair.first, pair.second}) {
    const ContourSlice& slice = moving.stack.slices[index];
    if (slice.contours.empty()) continue;
    const Eigen::Vector2d middle = slice.pose.world_to_slice(place.middle_mm());
    const double distance_mm = signed_distance_mm(slice.contours, middle);
    if (std::abs(distance_mm) >= std::abs(equation.mismatch_mm)) continue;
    equation.mismatch_mm = distance_mm;
    equation.terms = {term_for(moving, index, place.middle_mm(), -distance_gradient(slice, middle))};
  }
  return equation;
}

std::vector<Equation> equations_for(const MovingSlices& moving, const Contradictions& contradictions) {
  std::vector<Equation> equations;
  for (const SlicePair& pair : contradictions.pairs)
    for (const Contradiction& place : pair.places)
      equations.push_back(place.is_matched() ? matched_equation(moving, pair, place)
                                             : missing_equation(moving, pair, place));
  return equations;
}

double huber(double residual, double knee) {
  const double r = std::abs(residual);
  return r < knee ? r * r : knee * (2 * r - knee);
}

/// The weight of a square that stands for the Huber loss (iteratively reweighted least squares).
double huber_weight(double residual, double knee) { return std::min(1.0, knee / std::max(std::abs(residual), 1e-12)); }

Eigen::Vector3d as_lengths(const MovingSlices& moving, std::size_t slice) {
  const InPlaneMotion& m = moving.motions[slice];
  return {m.shift_mm.x(), m.shift_mm.y(), m.rotation_rad * moving.reach_mm[slice]};
}

/// Beyond this a motion's cost grows linearly.
double stay_knee(double knee_mm) { return 0.2 * knee_mm; }

double cost_of(const MovingSlices& moving, const std::vector<Equation>& equations, double stay, double knee_mm) {
  double cost = 0;
  for (const Equation& equation : equations) cost += huber(equation.mismatch_mm, knee_mm);
  for (std::size_t s = 0; s < moving.motions.size(); ++s)
    cost += stay * huber(as_lengths(moving, s).norm(), stay_knee(knee_mm));
  return cost;
}

/// The Gauss–Newton step, `unknowns()` numbers per slice.
Eigen::VectorXd step_for(const MovingSlices& moving, const std::vector<Equation>& equations,
                         const AlignOptions& options, double knee_mm) {
  const int n = moving.unknowns();
  const auto size = static_cast<Eigen::Index>(moving.motions.size()) * n;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  for (std::size_t s = 0; s < moving.motions.size(); ++s) {
    const Eigen::Vector3d motion = as_lengths(moving, s);
    const double weight = options.stay * huber_weight(motion.norm(), stay_knee(knee_mm));
    const auto row = static_cast<Eigen::Index>(s) * n;
    right.segment(row, n) = -weight * motion.head(n);
    normal.diagonal().segment(row, n).setConstant(weight);
  }
  for (const Equation& equation : equations) {
    const double weight = huber_weight(equation.mismatch_mm, knee_mm);
    for (const Equation::Term& a : equation.terms) {
      const auto row = static_cast<Eigen::Index>(a.slice) * n;
      right.segment(row, n) -= weight * equation.mismatch_mm * a.gradient.head(n);
      for (const Equation::Term& b : equation.terms)
        normal.block(row, static_cast<Eigen::Index>(b.slice) * n, n, n) +=
            weight * a.gradient.head(n) * b.gradient.head(n).transpose();
    }
  }
  return normal.ldlt().solve(right);
}

MovingSlices moved_by(MovingSlices moving, const Eigen::VectorXd& step, const AlignOptions& options) {
  const int n = moving.unknowns();
  const double most_rad = options.max_rotation_deg * std::numbers::pi / 180;
  for (std::size_t s = 0; s < moving.motions.size(); ++s) {
    const auto part = step.segment(static_cast<Eigen::Index>(s) * n, n);
    InPlaneMotion& m = moving.motions[s];
    m.shift_mm += part.head<2>();
    if (m.shift_mm.norm() > options.max_shift_mm) m.shift_mm *= options.max_shift_mm / m.shift_mm.norm();
    if (n == 3) m.rotation_rad = std::clamp(m.rotation_rad + part[2] / moving.reach_mm[s], -most_rad, most_rad);
    moving.stack.slices[s].pose = moved_in_plane(moving.original.slices[s].pose, m, moving.centres_mm[s]);
  }
  return moving;
}

}  // namespace

SlicePose moved_in_plane(const SlicePose& pose, const InPlaneMotion& motion, const Eigen::Vector2d& centre_mm) {
  const double c = std::cos(motion.rotation_rad), s = std::sin(motion.rotation_rad);
  SlicePose moved = pose;
  moved.x_axis = c * pose.x_axis + s * pose.y_axis;
  moved.y_axis = c * pose.y_axis - s * pose.x_axis;
  const Eigen::Vector3d centre = pose.slice_to_world(centre_mm + motion.shift_mm);
  moved.origin_mm = centre - centre_mm.x() * moved.x_axis - centre_mm.y() * moved.y_axis;
  return moved;
}

Alignment align_slices(const ContourStack& stack, const AlignOptions& options, const Progress& progress) {
  double pixel_mm = std::numeric_limits<double>::infinity();
  for (const ContourSlice& slice : stack.slices) pixel_mm = std::min(pixel_mm, slice.pose.spacing_mm.minCoeff());
  const double knee_mm = options.robust_pixels * pixel_mm;

  Alignment result{.stack = stack, .motions = {}, .before = find_contradictions(stack), .after = {}};
  MovingSlices moving = at_rest(stack, options.rotation);
  result.after = result.before;
  std::vector<Equation> equations = equations_for(moving, result.before);
  double cost = cost_of(moving, equations, options.stay, knee_mm);
  for (double damping = 1; result.iterations < options.iterations && damping > 0.02; ++result.iterations) {
    progress.report("align", static_cast<double>(result.iterations) / options.iterations);
    const Eigen::VectorXd step = damping * step_for(moving, equations, options, knee_mm);
    if (step.size() == 0 || step.cwiseAbs().maxCoeff() < 1e-3 * pixel_mm) break;
    MovingSlices tried = moved_by(moving, step, options);
    Contradictions left = find_contradictions(tried.stack, {.refuse_duplicates = false});
    std::vector<Equation> tried_equations = equations_for(tried, left);
    const double tried_cost = cost_of(tried, tried_equations, options.stay, knee_mm);
    if (tried_cost >= cost) {
      damping /= 2;
      continue;
    }
    damping = std::min(1.0, 2 * damping);
    cost = tried_cost;
    moving.stack = std::move(tried.stack);
    moving.motions = std::move(tried.motions);
    equations = std::move(tried_equations);
    result.after = std::move(left);
  }
  result.stack = std::move(moving.stack);
  result.motions = std::move(moving.motions);
  return result;
}

}  // namespace isostack
