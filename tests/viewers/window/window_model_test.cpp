#include "viewers/window/window_model.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <numbers>
#include <thread>

#include "recon/geometry/errors.h"
#include "tests/support/analytic_meshes.h"
#include "tests/support/analytic_shapes.h"
#include "tests/viewers/window/ball_images.h"

namespace isostack {
namespace {

namespace fs = std::filesystem;
using testing_support::ball_images;

constexpr double radius_mm = 10;

/// A ball in nine images with its contours (of 60 points) and surface.
WindowContent ball() {
  WindowContent content;
  content.scene.slices = ball_images(9);
  content.scene.contours =
      scene_contours({testing_support::sphere_cuts(radius_mm, {}, {-16, -12, -8, -4, 0, 4, 8, 12, 16}, 60)});
  content.scene.surfaces = scene_surfaces({testing_support::sphere_mesh({0, 0, 0}, radius_mm, 64, 32)});
  content.session.inputs = {"series", "ball.vtp", "ball.stl"};
  content.session_file = fs::path(testing::TempDir()) / ("isostack_model_" + std::to_string(::getpid()) + ".json");
  content.reconstruct.resolution_mm = 1;
  content.reconstruct.solver = SolverChoice::fast;  // as the program's window has it
  return content;
}

/// Lets it work, a minute at most, until nothing runs.
void wait_for_work(WindowModel& model) {
  for (int i = 0; i < 6000 && model.is_busy(); ++i) {
    model.tick(0.01);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  model.tick(0.01);
}

/// The shown slice's coordinates of a world point.
Eigen::Vector2d on_slice(const WindowModel& model, const Eigen::Vector3d& point_mm) {
  return model.shown_plane()->pose.world_to_slice(point_mm);
}

/// Drags the contour's point at (10, 0, 0) of the middle slice outwards.
void pull_point(WindowModel& model, double to_mm) {
  model.act(ViewAction::edit_mode);
  model.press(on_slice(model, {radius_mm, 0, 0}), 0.5);
  model.drag(on_slice(model, {(radius_mm + to_mm) / 2, 0, 0}));
  model.drag(on_slice(model, {to_mm, 0, 0}));
  model.release();
}

TEST(WindowModel, OpensAtTheMiddleSliceAndScrolls) {
  WindowModel model(ball());
  ASSERT_EQ(model.planes().size(), 9U);
  EXPECT_EQ(model.state().plane, 4U);
  const std::uint64_t before = model.revision(WindowPart::slice);
  model.act(ViewAction::next_plane);
  EXPECT_EQ(model.shown_plane()->name, "slice 5");
  EXPECT_GT(model.revision(WindowPart::slice), before);
  model.act(ViewAction::ten_planes_on);
  EXPECT_EQ(model.state().plane, 8U) << "scrolling stops at the last";
  model.act(ViewAction::first_plane);
  EXPECT_EQ(model.state().plane, 0U);
  EXPECT_TRUE(model.scene().slices[0].visible);
  EXPECT_FALSE(model.scene().slices[4].visible) << "the scene has the shown slice only";
}

TEST(WindowModel, LayersAndClipping) {
  WindowModel model(ball());
  EXPECT_FALSE(model.cut().lines.empty());
  model.act(ViewAction::show_surfaces);
  EXPECT_FALSE(model.scene().surfaces[0].visible);
  EXPECT_TRUE(model.cut().lines.empty()) << "what is hidden has no cut line";
  model.act(ViewAction::show_surfaces);
  model.act(ViewAction::next_images);
  for (const SceneSlice& slice : model.scene().slices) EXPECT_TRUE(slice.visible);
  EXPECT_FALSE(model.clip().has_value());
  model.act(ViewAction::next_clip);
  ASSERT_TRUE(model.clip().has_value());
  EXPECT_NEAR(model.clip()->signedDistance({0, 0, -3}), 3, 1e-12) << "what is in front of the slice is hidden";
  model.act(ViewAction::next_clip);
  EXPECT_NEAR(model.clip()->signedDistance({0, 0, -3}), -3, 1e-12);
}

TEST(WindowModel, PicksAndMeasures) {
  WindowModel model(ball());
  model.press(on_slice(model, {3.4, 0, 0}), 0.5);
  ASSERT_EQ(model.picks().size(), 1U);
  EXPECT_NEAR(model.picks()[0].grey.value_or(0), 100, 15) << "the images' noise";
  EXPECT_EQ(model.picks()[0].inside, std::vector<std::string>{"sphere"});
  EXPECT_NEAR(model.picks()[0].surfaces[0].distance_mm, 6.6, 0.06) << "the mesh's facets lie 0.05 mm inside";
  model.click({{100, 1, 2}, {-1, 0, 0}});  // from the left, in the 3D scene
  ASSERT_EQ(model.picks().size(), 2U);
  EXPECT_NEAR(model.picks()[1].point_mm.norm(), radius_mm, 0.06);

  model.act(ViewAction::measure_mode);
  model.press(on_slice(model, {-3, 1, 0}), 0.5);
  EXPECT_TRUE(model.measuring_from());
  model.press(on_slice(model, {0, 5, 0}), 0.5);
  ASSERT_EQ(model.state().measurements.size(), 1U);
  EXPECT_NEAR(model.state().measurements[0].length_mm(), 5, 1e-12);
  ASSERT_EQ(model.scene().marks.size(), 1U);
  EXPECT_EQ(model.scene().marks[0].text, "5.0 mm");
  model.act(ViewAction::clear_marks);
  EXPECT_TRUE(model.picks().empty());
  EXPECT_TRUE(model.scene().marks.empty());
}

TEST(WindowModel, AClickOfThe3DSceneTakesWhatIsInFront) {
  WindowModel model(ball());
  model.act(ViewAction::show_surfaces);
  model.click({{2, 3, 50}, {0, 0, -1}});
  ASSERT_EQ(model.picks().size(), 1U);
  EXPECT_TRUE(model.picks()[0].point_mm.isApprox(Eigen::Vector3d(2, 3, 0), 1e-9)) << "the slice shown";
  model.click({{200, 3, 50}, {0, 0, -1}});
  EXPECT_EQ(model.picks().size(), 1U) << "nothing there";
}

TEST(WindowModel, DragsAPointAndUndoesIt) {
  WindowModel model(ball());
  model.act(ViewAction::edit_mode);
  model.press(on_slice(model, {radius_mm, 0, 0}), 0.5);
  model.drag(on_slice(model, {13, 0, 0}));
  const ViewPlane::Drawn drawn = model.shown_plane()->contours[0];
  EXPECT_NEAR((*model.contours_on_plane(drawn))[0].points_mm[0].norm(), 13, 1e-9) << "shown while it is dragged";
  EXPECT_TRUE(model.edits().steps().empty()) << "and nothing is changed yet";
  model.release();
  ASSERT_EQ(model.edits().steps().size(), 1U);
  const auto& points = model.scene().contours[0].stack.slices[drawn.slice].contours[0].points_mm;
  EXPECT_NEAR(points[0].norm(), 13, 1e-9);
  EXPECT_GT(points[1].norm(), 12) << "its neighbours came with it";
  model.act(ViewAction::undo);
  EXPECT_NEAR(model.scene().contours[0].stack.slices[drawn.slice].contours[0].points_mm[0].norm(), radius_mm, 1e-9);
  model.act(ViewAction::redo);
  EXPECT_NEAR(model.scene().contours[0].stack.slices[drawn.slice].contours[0].points_mm[0].norm(), 13, 1e-9);
}

TEST(WindowModel, ClicksAddAndDeletePointsAndAStillClickChangesNothing) {
  WindowModel model(ball());
  model.act(ViewAction::edit_mode);
  model.press(on_slice(model, {radius_mm, 0, 0}), 0.2);
  model.release();
  EXPECT_TRUE(model.edits().steps().empty());
  const double half = std::numbers::pi / 60;  // between the first two points
  const Eigen::Vector3d between = radius_mm * std::cos(half) * Eigen::Vector3d(std::cos(half), std::sin(half), 0);
  model.press(on_slice(model, between), 0.2);
  model.release();
  const std::size_t slice = model.shown_plane()->contours[0].slice;
  const auto count = [&] { return model.scene().contours[0].stack.slices[slice].contours[0].points_mm.size(); };
  EXPECT_EQ(count(), 61U);
  model.point_at(on_slice(model, between), 0.2);
  model.act(ViewAction::delete_point);
  EXPECT_EQ(count(), 60U);
  model.press(on_slice(model, {0, 0, 0}), 0.2);
  model.release();
  EXPECT_EQ(model.edits().steps().size(), 2U) << "the middle of the ball is not near its contour";
}

TEST(WindowModel, ADragThatWouldCrossTheContourIsRefused) {
  WindowModel model(ball());
  model.act(ViewAction::edit_mode);
  for (int k = 0; k < 20; ++k) model.act(ViewAction::shorter_reach);  // one point only
  model.press(on_slice(model, {radius_mm, 0, 0}), 0.5);
  model.drag(on_slice(model, {-20, 0.3, 0}));
  EXPECT_NE(model.message().find("cross itself"), std::string::npos) << model.message();
  model.release();
  EXPECT_TRUE(model.edits().steps().empty());
}

TEST(WindowModel, SolvesEditedContoursInTheBackground) {
  WindowModel model(ball());
  pull_point(model, 14);
  model.act(ViewAction::solve);
  EXPECT_TRUE(model.is_busy());
  model.act(ViewAction::next_plane);  // and meanwhile goes on
  model.act(ViewAction::previous_plane);
  wait_for_work(model);
  ASSERT_EQ(model.solve_status().state, TaskState::done) << model.solve_status().message;
  EXPECT_EQ(model.surface_revisions()[0], 2U);
  const auto tip = hit_on_surfaces({{100, 0, 0}, {-1, 0, 0}}, model.scene().surfaces, std::nullopt);
  ASSERT_TRUE(tip.has_value());
  EXPECT_NEAR(tip->x(), 14, 0.3) << "the surface goes through the pulled contour, to within a quarter of a pixel";
  const auto opposite = hit_on_surfaces({{-100, 0, 0}, {1, 0, 0}}, model.scene().surfaces, std::nullopt);
  EXPECT_NEAR(opposite->x(), -radius_mm, 0.3);
  EXPECT_TRUE(model.state().is_solved);
  EXPECT_NE(model.message().find("solved"), std::string::npos);
}

TEST(WindowModel, ACancelledSolveLeavesTheSurface) {
  WindowModel model(ball());
  model.act(ViewAction::solve);
  model.act(ViewAction::cancel);
  wait_for_work(model);
  EXPECT_EQ(model.solve_status().state, TaskState::cancelled);
  EXPECT_EQ(model.surface_revisions()[0], 1U);
}

TEST(WindowModel, DroppingAllSlicesButOneIsToldWhenSolved) {
  WindowModel model(ball());
  for (int plane = 0; plane < 8; ++plane) {
    model.show_plane(plane);
    model.act(ViewAction::drop_slice);
  }
  EXPECT_EQ(model.edits().kept_organs()[0].slices.size(), 1U);
  model.act(ViewAction::solve);
  wait_for_work(model);
  EXPECT_NE(model.solve_status().state, TaskState::done);
  EXPECT_NE(model.message(), "solving in the background") << "its failure is told";
}

TEST(WindowModel, SeedsSegmentAndUndoBringsTheContoursBack) {
  WindowModel model(ball());
  model.act(ViewAction::segment);
  EXPECT_NE(model.message().find("no seed"), std::string::npos);
  model.act(ViewAction::seed_mode);
  model.press(on_slice(model, {1, 1, 0}), 0.5);
  model.act(ViewAction::segment);
  wait_for_work(model);
  ASSERT_EQ(model.segmentation_status().state, TaskState::done) << model.segmentation_status().message;
  EXPECT_TRUE(model.state().is_segmented);
  EXPECT_EQ(model.scene().contours[0].stack.name, "organ");
  model.act(ViewAction::replay);
  ASSERT_TRUE(model.replayed_contours());
  model.act(ViewAction::undo);
  EXPECT_EQ(model.scene().contours[0].stack.name, "sphere");
  EXPECT_FALSE(model.state().is_segmented);
}

TEST(WindowModel, SeedsAreOfSeveralOrgansAndOfWhatIsNotWanted) {
  WindowModel model(ball());
  model.act(ViewAction::seed_mode);
  const auto seed_and_next = [&](const Eigen::Vector3d& point) {
    model.press(on_slice(model, point), 0.5);
    model.act(ViewAction::next_organ);
  };
  model.act(ViewAction::next_organ);  // nothing is seeded yet: only what is not wanted is left
  seed_and_next({20, 0, 0});
  seed_and_next({1, 1, 0});
  seed_and_next({2, 1, 0});
  model.act(ViewAction::next_organ);  // past another new one
  model.act(ViewAction::next_organ);  // and what is not wanted
  seed_and_next({3, 1, 0});
  std::vector<std::string> names;
  for (const ViewSeed& seed : model.state().seeds) names.push_back(seed.name);
  EXPECT_EQ(names, (std::vector<std::string>{"-", "organ", "organ 2", "organ"}));
}

TEST(WindowModel, ASavedSessionOpensAsItWas) {
  fs::path file;
  std::string contours;
  {
    WindowModel model(ball());
    pull_point(model, 13);
    model.act(ViewAction::pick_mode);
    model.press(on_slice(model, {3, 0, 0}), 0.5);
    model.act(ViewAction::next_clip);
    model.act(ViewAction::solve);
    wait_for_work(model);
    model.act(ViewAction::save_session);
    EXPECT_NE(model.message().find("saved"), std::string::npos) << model.message();
  }
  WindowContent content = ball();
  file = content.session_file;
  content.session = read_view_session(file);
  fs::remove(file);
  WindowModel again(std::move(content));
  EXPECT_EQ(again.state().clip, ClipSide::front);
  EXPECT_EQ(again.picks().size(), 1U);
  EXPECT_TRUE(again.picks()[0].grey.has_value()) << "facts are looked up anew";
  EXPECT_EQ(again.edits().steps().size(), 1U);
  EXPECT_TRUE(again.is_busy()) << "the surface is solved anew";
  wait_for_work(again);
  const auto tip = hit_on_surfaces({{100, 0, 0}, {-1, 0, 0}}, again.scene().surfaces, std::nullopt);
  EXPECT_NEAR(tip->x(), 13, 0.3);
}

TEST(WindowModel, EditsThatDoNotFitTheContoursAreRefused) {
  WindowContent content = ball();
  content.session.state.edits = {{{.kind = EditKind::drop_slice, .slice = 99}}};
  EXPECT_THROW(WindowModel model(std::move(content)), InputError);
}

TEST(WindowModel, PlaysAMorph) {
  WindowContent content;
  for (const double radius : {8.0, 10.0, 12.0})
    content.frames.push_back(testing_support::sphere_mesh({0, 0, 0}, radius, 16, 8));
  WindowModel model(std::move(content));
  const auto shown = [&] {
    std::vector<std::size_t> frames;
    for (std::size_t i = 0; i < model.scene().surfaces.size(); ++i)
      if (model.scene().surfaces[i].visible) frames.push_back(i);
    return frames;
  };
  EXPECT_EQ(shown(), std::vector<std::size_t>{0});
  model.act(ViewAction::next_frame);
  EXPECT_EQ(shown(), std::vector<std::size_t>{1});
  EXPECT_NE(model.status_text().find("frame 2 of 3"), std::string::npos) << model.status_text();
  EXPECT_EQ(model.scene().surfaces[0].mesh.color, model.scene().surfaces[2].mesh.color);
  model.act(ViewAction::play);
  model.tick(0.1);  // one frame at 12 a second
  EXPECT_EQ(shown(), std::vector<std::size_t>{2});
  model.show_frame(0);
  EXPECT_EQ(shown(), std::vector<std::size_t>{0});
}

TEST(WindowModel, AskedForWhatIsNotThereItSaysSo) {
  WindowContent content;
  content.scene.surfaces = scene_surfaces({testing_support::box_mesh({-1, -1, -1}, {1, 1, 1})});
  content.session_file = ball().session_file;
  WindowModel model(std::move(content));
  const std::string before = model.message();
  for (const ViewKey& key : view_keys()) model.act(key.action);
  fs::remove(ball().session_file);
  EXPECT_NE(model.message(), before);
  model.act(ViewAction::undo);
  EXPECT_EQ(model.message(), "there is nothing to undo");
  model.act(ViewAction::solve);
  EXPECT_EQ(model.message(), "there are no contours to solve through");
}

}  // namespace
}  // namespace isostack
