#include "recon/morphing/subdivision_morph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "recon/geometry/errors.h"
#include "recon/geometry/self_crossing.h"
#include "recon/metrics/frame_quality.h"
#include "sample_data/outlines.h"

namespace isostack {
namespace {

KeyShape outline(const std::string& name) {
  for (const ContourSlice& figure : outline_figures())
    if (figure.name == name) return {.name = name, .shape = figure};
  throw std::invalid_argument(name);
}

const std::vector<Contour>& contours_of(const Shape& shape) { return std::get<ContourSlice>(shape).contours; }

double diagonal_mm(const std::vector<KeyShape>& shapes) { return box_of(shapes).diagonal().norm(); }

double distance_to_vertices(const std::vector<Contour>& contours, const Eigen::Vector2d& point) {
  double least = 1e9;
  for (const Contour& contour : contours)
    for (const Eigen::Vector2d& vertex : contour.points_mm) least = std::min(least, (vertex - point).norm());
  return least;
}

/// The largest distance of a vertex of the shape from the frame's vertices.
double off_source(const KeyShape& shape, const Shape& frame) {
  double largest = 0;
  for (const Contour& contour : contours_of(shape.shape))
    for (const Eigen::Vector2d& point : contour.points_mm)
      largest = std::max(largest, distance_to_vertices(contours_of(frame), point));
  return largest;
}

std::vector<std::size_t> holes_of(const std::vector<Shape>& frames) {
  std::vector<std::size_t> holes;
  for (const Shape& frame : frames) holes.push_back(frame_quality(frame).holes);
  return holes;
}

template <class Change>
std::string refusal(const std::vector<KeyShape>& shapes, Change change) {
  SubdivisionMorphOptions options;
  change(options);
  try {
    subdivision_morph(shapes, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SubdivisionMorph, MeetsEveryVertexOfItsShapesInEveryCombination) {
  for (const auto& names : std::vector<std::vector<std::string>>{
           {"eight", "seven"}, {"two", "three"}, {"pointed", "fan", "triangle"}, {"seven", "eight"}}) {
    std::vector<KeyShape> shapes;
    for (const std::string& name : names) shapes.push_back(outline(name));
    const std::vector<Shape> frames = subdivision_morph(shapes, {}).frames(2 * (shapes.size() - 1) + 1);
    for (std::size_t i = 0; i < shapes.size(); ++i)
      EXPECT_LE(off_source(shapes[i], frames[2 * i]), 1e-6 * diagonal_mm(shapes)) << names[i];
    for (const Shape& frame : frames)
      for (const Contour& contour : contours_of(frame)) EXPECT_FALSE(self_crossing(contour)) << names[0];
  }
}

TEST(SubdivisionMorph, KeepsAllSidesStraightAtTheEndsUnlessAskedToRoundThem) {
  const std::vector<KeyShape> shapes = {outline("fan"), outline("pointed")};
  const auto area_at_start = [&](std::optional<double> sharp_angle_rad) {
    return frame_quality(subdivision_morph(shapes, {.sharp_angle_rad = sharp_angle_rad}).shape_at(0)).content;
  };
  const double polygon = frame_quality(shapes[0].shape).content;
  EXPECT_NEAR(area_at_start({}), polygon, 1e-9 * polygon);  // rounding
  // 44 mm round the middle of its arc, over 140 degrees; sagitta r (1 - cos 7.5 degrees), two thirds of it in area.
  const double round = 44 * (1 - std::cos(7 * std::numbers::pi / 180)) * 2 / 3 * 44 * 140 * std::numbers::pi / 180;
  EXPECT_NEAR(area_at_start(40 * std::numbers::pi / 180) - polygon, round, 0.15 * round);  // cubics, not circles
}

TEST(SubdivisionMorph, ClosesHolesByItselfAndOpensThemWithAKeyShape) {
  const std::vector<KeyShape> shapes = {outline("eight"), outline("seven")};
  const std::vector<std::size_t> closing = {2, 2, 0, 0};
  const Morph by_itself = subdivision_morph(shapes, {});
  const Morph with_key =
      subdivision_morph(shapes, {.key_shapes = {{.name = "key", .shape = outline("eight_to_seven").shape, .t = 0.5}}});
  const auto frames_of = [](const Morph& morph) {
    return std::vector<Shape>{morph.shape_at(0), morph.shape_at(0.45), morph.shape_at(0.55), morph.shape_at(1)};
  };
  EXPECT_EQ(holes_of(frames_of(by_itself)), closing);
  EXPECT_EQ(holes_of(frames_of(with_key)), closing);
  const Eigen::Vector2d in_upper_hole(44, 30);
  EXPECT_TRUE(is_inside(contours_of(by_itself.shape_at(0.55)), in_upper_hole));
  EXPECT_FALSE(is_inside(contours_of(with_key.shape_at(0.55)), in_upper_hole)) << "it opens to the left";
}

TEST(SubdivisionMorph, CorrespondingPointsStayOnTheirLineInEveryFrame) {
  const std::vector<KeyShape> shapes = {outline("pointed"), outline("triangle")};
  const Eigen::Vector2d arm(86.04, 37.64), corner(84, 78), bend(95, 60);
  CorrespondingPoints feature{.from = {.shape = 0, .vertex = {}, .place_mm = arm}, .to = {.shape = 1, .vertex = 1}};
  const Morph straight = subdivision_morph(shapes, {.features = {feature}});
  feature.by_way_of = {{.t = 0.5, .place_mm = bend}};
  const Morph curved = subdivision_morph(shapes, {.features = {feature}});
  const Eigen::Vector2d true_arm = contours_of(shapes[0].shape)[0].points_mm[2];
  const double allowed_mm = 0.01 * diagonal_mm(shapes);
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    const Eigen::Vector2d on_line = (1 - t) * true_arm + t * corner;
    EXPECT_LE(distance_to_vertices(contours_of(straight.shape_at(t)), on_line), allowed_mm) << t;
    // The parabola through the three points, at 0, 0.5 and 1.
    const Eigen::Vector2d on_curve =
        (1 - t) * (1 - 2 * t) * true_arm + 4 * t * (1 - t) * bend + t * (2 * t - 1) * corner;
    EXPECT_LE(distance_to_vertices(contours_of(curved.shape_at(t)), on_curve), allowed_mm) << t;
  }
}

TEST(SubdivisionMorph, ASharpFeatureStaysACorner) {
  const std::vector<KeyShape> shapes = {outline("pointed"), outline("triangle")};
  CorrespondingPoints tip{.from = {.shape = 0, .vertex = 0}, .to = {.shape = 1, .vertex = 0}};
  const auto turn_at_tip = [&](bool sharp) {
    tip.sharp = sharp;
    const Morph morph = subdivision_morph(shapes, {.features = {tip}});
    return frame_quality(morph.shape_at(0.5), {.curvature_scale_mm = 1}).highest_curvature;
  };
  EXPECT_GT(turn_at_tip(true), 1.3 * turn_at_tip(false));
}

TEST(SubdivisionMorph, TransitionsArePulledToTheirPlaces) {
  const std::vector<KeyShape> shapes = {outline("two"), outline("three")};
  const Eigen::Vector2d to(20, 46);
  for (const int level : {1, 2, 3}) {
    EnhancedTransition transition;
    transition.level = level;
    transition.at = {.t = 0.5, .place_mm = Eigen::Vector2d(40, 52)};
    transition.to_mm = to;
    SubdivisionMorphOptions options;
    options.transitions.push_back(transition);
    const Morph morph = subdivision_morph(shapes, options);
    EXPECT_LE(distance_to_vertices(contours_of(morph.shape_at(0.5)), to), 1e-9) << level;
  }
}

TEST(SubdivisionMorph, SweepsWhileTheEndsStay) {
  const std::vector<KeyShape> shapes = {outline("three"), outline("one")};
  const Morph plain = subdivision_morph(shapes, {});
  const Morph swept = subdivision_morph(shapes, {.warp = sweep(Eigen::Vector2d(0, 1), 0.9)});
  EXPECT_LE(off_source(shapes[0], swept.shape_at(0)), 1e-6 * diagonal_mm(shapes));
  EXPECT_LE(off_source(shapes[1], swept.shape_at(1)), 1e-6 * diagonal_mm(shapes));
  // Half-way the lower part is still more of a 3 and the upper part already more of a 1.
  const auto unlike = [&](const Morph& morph, const KeyShape& shape, double from_y_mm, double to_y_mm) {
    const Shape frame = morph.shape_at(0.5);
    int count = 0;
    for (double y = from_y_mm; y < to_y_mm; ++y)
      for (double x = 10.5; x < 85; ++x)
        count += is_inside(contours_of(frame), {x, y}) != is_inside(contours_of(shape.shape), {x, y}) ? 1 : 0;
    return count;
  };
  EXPECT_LT(unlike(swept, shapes[0], 60.5, 90), 0.8 * unlike(plain, shapes[0], 60.5, 90));
  EXPECT_LT(unlike(swept, shapes[1], 8.5, 35), 0.8 * unlike(plain, shapes[1], 8.5, 35));
}

TEST(SubdivisionMorph, DetailsLingerWhenAskedTo) {
  // A gear: a circle with thirty teeth of 1 mm.
  Contour gear;
  for (int i = 0; i < 240; ++i) {
    const double angle = 2 * std::numbers::pi * i / 240, radius = 30 + ((i / 4) % 2 == 0 ? 1 : -1);
    gear.points_mm.emplace_back(45 + radius * std::cos(angle), 45 + radius * std::sin(angle));
  }
  ContourSlice slice = std::get<ContourSlice>(outline("one").shape);
  slice.contours = {gear};
  const std::vector<KeyShape> shapes = {{.name = "a", .shape = slice}, {.name = "b", .shape = slice}};
  const auto perimeter = [&](DetailsBetween details) {
    return frame_quality(subdivision_morph(shapes, {.details = details, .tolerance_share = 0.03}).shape_at(0.5))
        .boundary;
  };
  EXPECT_LT(perimeter(DetailsBetween::fade), 1.1 * 2 * std::numbers::pi * 30);  // of a circle
  EXPECT_GT(perimeter(DetailsBetween::linger), 1.1 * perimeter(DetailsBetween::fade));
}

TEST(SubdivisionMorph, SaysWhatIsWrongAndWhatToDo) {
  const std::vector<KeyShape> shapes = {outline("pointed"), outline("triangle")};
  const auto with_vertex = [&](std::size_t shape, std::size_t vertex) {
    return refusal(shapes, [&](SubdivisionMorphOptions& options) {
      options.features = {{.from = {.shape = 0, .vertex = vertex}, .to = {.shape = shape, .vertex = 0}}};
    });
  };
  EXPECT_NE(with_vertex(1, 10).find("vertex 10, but it has 10"), std::string::npos) << with_vertex(1, 10);
  EXPECT_NE(with_vertex(2, 0).find("shape 2 of 2"), std::string::npos);
  EXPECT_NE(with_vertex(0, 0).find("do not follow"), std::string::npos);
  const auto with_key_at = [&](double t) {
    return refusal(shapes, [&](SubdivisionMorphOptions& options) {
      options.key_shapes = {{.name = "key.json", .shape = shapes[0].shape, .t = t}};
    });
  };
  EXPECT_NE(with_key_at(1.5).find("key.json"), std::string::npos);
  EXPECT_NE(with_key_at(0).find("not between"), std::string::npos);
  std::vector<KeyShape> crossing = shapes;
  auto& points = std::get<ContourSlice>(crossing[1].shape).contours[0].points_mm;
  points = {{0, 0}, {40, 40}, {40, 0}, {0, 30}};
  EXPECT_NE(refusal(crossing, [](auto&) {}).find("cross at"), std::string::npos) << refusal(crossing, [](auto&) {});
  crossing[1] = shapes[1];
  std::get<ContourSlice>(crossing[1].shape).contours.clear();
  EXPECT_NE(refusal(crossing, [](auto&) {}).find("triangle"), std::string::npos);
  EXPECT_NE(refusal(shapes, [](SubdivisionMorphOptions& options) { options.levels = 0; }), "");
}

}  // namespace
}  // namespace isostack
