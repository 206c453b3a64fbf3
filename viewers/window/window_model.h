#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recon/reconstruct.h"
#include "viewers/scene.h"
#include "viewers/view_planes.h"
#include "viewers/window/background_task.h"
#include "viewers/window/contour_edit.h"
#include "viewers/window/pick.h"
#include "viewers/window/plane_cut.h"
#include "viewers/window/playback.h"
#include "viewers/window/seed_segmentation.h"
#include "viewers/window/view_keys.h"
#include "viewers/window/view_session.h"

namespace isostack {

/// What may have to be drawn anew.
enum class WindowPart {
  looks,     ///< of the scene's items: visible, opacity, style; the clip plane
  contours,  ///< of the scene
  marks,     ///< in the scene: picks, seeds, distances, cut lines
  slice,     ///< anything the slice's panel shows
  grey,
  layout,
  text,
  count
};

struct WindowContent {
  Scene scene;
  std::vector<TriangleMesh> frames = {};                      ///< of a morph, in order
  std::vector<TriangleMesh> beside = {};                      ///< a second result
  ViewSession session = {};                                   ///< its paths name where all that came from
  std::filesystem::path session_file = "isostack-view.json";  ///< where the session is saved
  std::filesystem::path picture_file = "isostack-view.png";
  ReconstructOptions reconstruct = {};  ///< how edited contours are solved
};

/// A window without the window: what is shown, and what keys, clicks and finished work change. Nothing in it draws, and
/// no function takes long; long work runs in the background until tick() takes its result. To be used from one thread.
/// Failures of what the user asked for become the message; only the constructor throws.
class WindowModel {
 public:
  /// Throws InputError when edits of the session do not fit the contours.
  explicit WindowModel(WindowContent content);

  const Scene& scene() const { return scene_; }
  /// The second result with the same contours; empty without one.
  const Scene& beside() const { return beside_; }
  const ViewState& state() const { return session_.state; }
  const ViewSession& session() const { return session_; }
  const std::vector<ViewPlane>& planes() const { return planes_; }
  /// Null when there is none.
  const ViewPlane* shown_plane() const;
  /// Contours of an organ on the shown plane; null where it has none. Those being dragged are as dragged.
  const std::vector<Contour>* contours_on_plane(const ViewPlane::Drawn& drawn) const;
  bool is_dropped(const ViewPlane::Drawn& drawn) const { return edits_.is_dropped(drawn.organ, drawn.slice); }
  const ContourEdits& edits() const { return edits_; }
  GreyWindow grey() const { return session_.state.grey.value_or(grey_); }
  /// Cut lines of the shown plane.
  const PlaneCut& cut();
  /// The half of space in which surfaces are shown.
  ClipPlane clip() const;
  std::size_t edited_organ() const { return organ_; }
  const Playback& morph() const { return morph_; }
  /// Curves of the replay at this moment; null when none is shown on the plane.
  const std::vector<Contour>* replayed_contours() const;
  const Eigen::Vector3d* measuring_from() const { return measuring_from_ ? &*measuring_from_ : nullptr; }
  const std::vector<PointFacts>& picks() const { return picks_; }
  TaskStatus solve_status() const { return solve_.status(); }
  TaskStatus segmentation_status() const { return segmentation_.status(); }
  bool is_busy() const { return solve_.is_running() || segmentation_.is_running(); }
  bool wants_help() const { return wants_help_; }
  bool wants_to_close() const { return wants_to_close_; }
  /// Where a picture is to be saved now; asked once.
  std::optional<std::filesystem::path> take_picture_request();
  /// The direction the camera is to look from now; asked once.
  std::optional<Eigen::Vector3d> take_camera_request();
  /// Grows with every change of the part.
  std::uint64_t revision(WindowPart part) const { return revisions_[static_cast<std::size_t>(part)]; }
  /// Grows with every change of that surface.
  const std::vector<std::uint64_t>& surface_revisions() const { return surface_revisions_; }

  /// What the last action gave, and what is going on: for the status lines.
  const std::string& message() const { return message_; }
  std::string status_text();

  void act(ViewAction action);
  void show_plane(std::ptrdiff_t plane);
  void show_frame(std::ptrdiff_t frame);
  void set_camera(const ViewCamera& camera) { session_.state.camera = camera; }
  void set_grey(const GreyWindow& grey);
  void say(const std::string& message);

  /// On the slice shown; places in its slice coordinates, `near_mm`: how far a click may be beside a point or line.
  void point_at(const std::optional<Eigen::Vector2d>& place_mm, double near_mm);
  void press(const Eigen::Vector2d& place_mm, double near_mm);
  void drag(const Eigen::Vector2d& place_mm);
  void release();
  /// In the 3D scene.
  void click(const Ray& ray);

  /// Takes finished work and lets morph and replay run by; `seconds` since the last call.
  void tick(double seconds);
  /// Cancels what runs in the background and waits until it has stopped.
  void stop();

 private:
  struct Drag {
    ViewPlane::Drawn drawn;
    EditStep step;                  ///< what it will have been
    std::vector<Contour> contours;  ///< as it would be now
    bool is_valid = true;
    bool has_moved = false;
  };

  ViewSession session_;
  Scene scene_, beside_;
  std::filesystem::path session_file_, picture_file_;
  ReconstructOptions reconstruct_;
  std::vector<ViewPlane> planes_;
  ContourEdits edits_;
  std::optional<ContourEdits> edits_before_segmentation_;
  std::vector<int> surface_of_organ_;
  std::size_t organ_ = 0;
  std::size_t first_frame_ = 0;  ///< among the scene's surfaces
  Playback morph_, replay_player_;
  EvolutionReplay replay_;
  bool shows_replay_ = false;
  std::vector<PointFacts> picks_;
  std::optional<Eigen::Vector3d> measuring_from_;
  std::string seed_name_ = ViewSeed().name;    ///< of the seeds that clicks place
  std::optional<Eigen::Vector2d> pointer_mm_;  ///< on the slice
  double pointer_near_mm_ = 0;
  std::optional<Drag> drag_;
  std::optional<PlaneCut> cut_;
  std::string message_, pointer_text_;
  bool wants_help_ = false, wants_to_close_ = false, wants_picture_ = false;
  std::optional<Eigen::Vector3d> wants_camera_;
  GreyWindow grey_;  ///< automatic
  std::array<std::uint64_t, static_cast<std::size_t>(WindowPart::count)> revisions_{};
  std::vector<std::uint64_t> surface_revisions_;
  std::vector<EditStep> edits_to_redo_;  ///< of a session, once its segmentation is there
  BackgroundTask<std::vector<Reconstruction>> solve_;
  BackgroundTask<SeedSegmentation> segmentation_;
  TaskState solve_told_ = TaskState::idle, segmentation_told_ = TaskState::idle;

  void changed(WindowPart part) { ++revisions_[static_cast<std::size_t>(part)]; }
  void take_up(const ViewState& state);
  bool act_on_view(ViewAction action);
  bool act_on_layers(ViewAction action);
  bool act_on_marks(ViewAction action);
  bool act_on_edits(ViewAction action);
  bool act_on_work(ViewAction action);
  void show_layers();
  void set_pointer(PointerMode mode, const char* says);
  void change_grey(double width_factor, double shift_share);
  void pick(const Eigen::Vector3d& point_mm);
  void use_point(const Eigen::Vector3d& point_mm);
  void update_marks();
  void contours_changed();
  void apply(const EditStep& step);
  std::optional<ViewPlane::Drawn> drawn_here() const;
  void begin_edit(const Eigen::Vector2d& place_mm, double near_mm);
  void delete_point_under_pointer();
  void drop_shown_slice();
  void undo();
  void tell_end(const TaskStatus& task, TaskState& told);
  void start_solve();
  void take_surfaces(std::vector<Reconstruction> solved);
  void start_segmentation();
  void take_segmentation(SeedSegmentation found);
  void set_organs(const std::vector<ContourStack>& organs);
  void save_session();
};

}  // namespace isostack
