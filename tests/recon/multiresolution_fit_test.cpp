#include "recon/subdivision/multiresolution_fit.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "recon/geometry/errors.h"
#include "recon/subdivision/figure_fit.h"
#include "recon/subdivision/simplex_section.h"

namespace isostack {
namespace {

constexpr double length_mm = 20;

Contour ellipse(double x_mm, double y_mm, int count = 48) {
  Contour contour;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    contour.points_mm.emplace_back(x_mm * std::cos(angle), y_mm * std::sin(angle));
  }
  return contour;
}

/// Each contour `length_mm` after the one before.
FitProblem problem_of(const std::vector<Contour>& contours, bool joined, double tolerance_mm = 0.3) {
  constexpr int levels = 4;
  std::vector<FigureLayer> layers;
  for (const Contour& contour : contours)
    layers.push_back({.t_mm = length_mm * static_cast<double>(layers.size()), .contours = {contour}});
  const FigureInterpolatorOptions options{.contours = {.levels = levels, .tolerance_mm = tolerance_mm}};
  return figure_problem(figure_interpolator(layers, options), levels, joined);
}

std::pair<double, double> radii_at(const SimplicialMesh& mesh, double t_mm) {
  double least = 1e9, largest = 0;
  for (const Contour& contour : section_contours(mesh, values_at_time(mesh, t_mm)))
    for (const Eigen::Vector2d& point : contour.points_mm) {
      least = std::min(least, point.norm());
      largest = std::max(largest, point.norm());
    }
  return {least, largest};
}

TEST(MultiresolutionFit, BetweenEqualCirclesIsACylinder) {
  // With the whole polygon as base like points are joined, and all frames are the 48-gon.
  const FittedMesh exact = fit_multiresolution(problem_of({ellipse(20, 20), ellipse(20, 20)}, true, 0.01), {});
  for (const double t : {0.5, 3.0, 10.0, 14.2}) {
    const auto [least, largest] = radii_at(exact.mesh, t);
    EXPECT_GT(least, 20 * std::cos(std::numbers::pi / 48) - 0.004) << t;  // the filter takes 2e-4 of a 48-gon
    EXPECT_LT(largest, 20) << t;
  }
  const FittedMesh coarse = fit_multiresolution(problem_of({ellipse(20, 20), ellipse(20, 20)}, true), {});
  for (const double t : {0.5, 3.0, 10.0, 14.2}) {
    const auto [least, largest] = radii_at(coarse.mesh, t);
    EXPECT_NEAR(least, 20, 0.17) << t;  // what a base of 32 sides at most may be off in the middle of two of three
    EXPECT_NEAR(largest, 20, 0.04) << t;
  }
}

TEST(MultiresolutionFit, BlendsAffineImagesLinearlyWhenNothingIsSmoothed) {
  FitProblem problem = problem_of({ellipse(20, 20), ellipse(31, 14)}, true);
  const FittedMesh fitted = fit_multiresolution(problem, {.smoothing_passes = 0});
  // The reference at the finest level is the straight blend.
  EXPECT_NEAR((fitted.mesh.vertices.topRows(2) - problem.reference.back()).cwiseAbs().maxCoeff(), 0, 1e-9);  // rounding
}

TEST(MultiresolutionFit, OfAffineImagesStaysNearTheStraightBlendWhenSmoothed) {
  const FittedMesh fitted = fit_multiresolution(problem_of({ellipse(20, 20), ellipse(30, 14)}, true), {});
  const auto [least, largest] = radii_at(fitted.mesh, length_mm / 2);
  // Half-way the straight blend of the two is an ellipse of 25 and 17 mm, but for where closest points are no affine
  // images of each other, and where the filter takes from the ends, which are curved most.
  EXPECT_NEAR(largest, 25, 0.25);
  EXPECT_NEAR(least, 17, 0.25);
}

TEST(MultiresolutionFit, LowersEnergyAndResidualAtEveryLevelAndMeetsTheSources) {
  const FitProblem problem = problem_of({ellipse(20, 20, 9), ellipse(30, 8, 14), ellipse(12, 20, 7)}, false);
  const FittedMesh fitted = fit_multiresolution(problem, {});
  ASSERT_EQ(fitted.levels.size(), 5U);
  for (std::size_t k = 1; k < fitted.levels.size(); ++k) {
    EXPECT_LT(fitted.levels[k].energy, fitted.levels[k].first_energy) << k;
    EXPECT_LE(fitted.levels[k].residual_mm, fitted.levels[k].first_residual_mm) << k;
    EXPECT_EQ(fitted.levels[k].residual_mm, 0) << k;
    EXPECT_TRUE(fitted.levels[k].converged) << k;
  }
  const PlacedVertices& held = problem.held.back();
  for (std::size_t i = 0; i < held.vertices.size(); ++i)
    EXPECT_EQ(
        (fitted.mesh.vertices.col(held.vertices[i]).head(2) - held.places_mm.col(static_cast<Eigen::Index>(i))).norm(),
        0);
}

TEST(MultiresolutionFit, GoesSmoothlyThroughAnInnerSource) {
  const FittedMesh fitted =
      fit_multiresolution(problem_of({ellipse(20, 20), ellipse(30, 30), ellipse(20, 20)}, true), {});
  const double step = 1;
  const double before =
      (radii_at(fitted.mesh, length_mm).second - radii_at(fitted.mesh, length_mm - step).second) / step;
  const double after =
      (radii_at(fitted.mesh, length_mm + step).second - radii_at(fitted.mesh, length_mm).second) / step;
  // Straight, the radius would grow by 0.5 mm per mm and shrink by as much; the sequence is its own mirror image.
  EXPECT_LT(std::abs(before), 0.1);
  EXPECT_LT(std::abs(after), 0.1);
}

TEST(MultiresolutionFit, PullsAChainOntoItsCurveAndTheSurroundingsAlong) {
  FitProblem problem = problem_of({ellipse(20, 20), ellipse(20, 20)}, true);
  const FittedMesh plain = fit_multiresolution(problem, {});
  const Eigen::MatrixXd& base = problem.base;
  int from = -1, to = -1;
  for (int v = 0; v < base.cols(); ++v)
    if ((base.col(v).head<2>() - Eigen::Vector2d(20, 0)).norm() < 1e-9) (base(2, v) == 0 ? from : to) = v;
  const auto curve = [](double t) -> Eigen::VectorXd {
    return Eigen::Vector2d(20 + 6 * std::sin(std::numbers::pi * t / length_mm), 0);
  };
  problem.constraints.push_back({.level = 0, .vertices = {from, to}, .place_mm = curve});
  const FittedMesh fitted = fit_multiresolution(problem, {});
  for (const int v : refined_chain({from, to}, problem.levels, 0, 4))
    EXPECT_EQ((fitted.mesh.vertices.col(v).head<2>() - curve(fitted.mesh.vertices(2, v))).norm(), 0);
  EXPECT_NEAR(radii_at(fitted.mesh, length_mm / 2).second, 26,
              0.1);  // beside it the smooth bump may be higher by so much
  // It is a bump, not a thorn: 3 mm beside it half of the pull is still felt; on the other side none is.
  const auto reach_at = [&](const FittedMesh& mesh, const Eigen::Vector2d& direction) {
    double reach = 0;
    for (const Contour& contour : section_contours(mesh.mesh, values_at_time(mesh.mesh, length_mm / 2)))
      for (const Eigen::Vector2d& point : contour.points_mm)
        if (point.normalized().dot(direction) > 0.9995) reach = std::max(reach, point.norm());
    return reach;
  };
  const Eigen::Vector2d beside(std::cos(0.15), std::sin(0.15));
  EXPECT_GT(reach_at(fitted, beside), reach_at(plain, beside) + 2);
  EXPECT_NEAR(reach_at(fitted, {-1, 0}), reach_at(plain, {-1, 0}), 0.3);  // 5 % of the pull, 40 mm away
}

TEST(MultiresolutionFit, PullsMoreLocallyAtFinerLevels) {
  const auto moved = [](int level) {
    FitProblem problem = problem_of({ellipse(20, 20), ellipse(20, 20)}, true);
    const FittedMesh plain = fit_multiresolution(problem, {});
    Eigen::MatrixXd mesh = problem.base;
    for (int k = 0; k < level; ++k) mesh = midpoint_refined(mesh, problem.levels.steps[static_cast<std::size_t>(k)]);
    Eigen::Index nearest = 0;
    (mesh.colwise() - Eigen::Vector3d(20, 0, length_mm / 2)).colwise().norm().minCoeff(&nearest);
    problem.constraints.push_back({.level = level,
                                   .vertices = {static_cast<int>(nearest)},
                                   .place_mm = [](double) -> Eigen::VectorXd { return Eigen::Vector2d(28, 0); }});
    const FittedMesh pulled = fit_multiresolution(problem, {});
    return ((pulled.mesh.vertices - plain.mesh.vertices).colwise().norm().array() > 0.1).cast<double>().mean();
  };
  const double coarse = moved(1), middle = moved(2), fine = moved(4);
  EXPECT_GT(coarse, 1.3 * middle);
  EXPECT_GT(middle, 1.3 * fine);
  EXPECT_GT(fine, 0);
}

TEST(MultiresolutionFit, DoesNotDependOnTheNumberOfThreads) {
  const FitProblem problem = problem_of({ellipse(20, 20, 9), ellipse(30, 8, 14)}, false);
  const FittedMesh many = fit_multiresolution(problem, {});
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(fit_multiresolution(problem, {}).mesh.vertices, many.mesh.vertices);
}

TEST(MultiresolutionFit, RefusesConstraintsThatNameWhatIsNotThere) {
  FitProblem problem = problem_of({ellipse(20, 20), ellipse(20, 20)}, false);
  const auto place = [](double) -> Eigen::VectorXd { return Eigen::Vector2d(0, 0); };
  problem.constraints = {{.level = 7, .vertices = {0}, .place_mm = place}};
  EXPECT_THROW(fit_multiresolution(problem, {}), InputError);
  problem.constraints = {{.level = 0, .vertices = {100000}, .place_mm = place}};
  EXPECT_THROW(fit_multiresolution(problem, {}), InputError);
}

}  // namespace
}  // namespace isostack
