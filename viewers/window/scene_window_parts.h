#pragma once

#include <vtkNew.h>

#include <optional>

#include "viewers/display.h"
#include "viewers/quiet_vtk.h"
#include "viewers/window/scene_panel.h"
#include "viewers/window/scene_window.h"
#include "viewers/window/slice_panel.h"
#include "viewers/window/status_panel.h"
#include "viewers/window/window_input.h"
#include "viewers/window/window_loss.h"

class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace isostack {

/// The window of open_scene_window(): panels that follow a model, and input that goes to it.
class SceneWindow : private WindowInput {
 public:
  SceneWindow(WindowModel& model, const SceneWindowOptions& options);
  ~SceneWindow() override;

  /// Handles events until the window is closed.
  void run();
  /// True when the window was taken away from outside.
  bool is_lost() const { return loss_->has_happened(); }
  const SceneWindowReport& report() const { return report_; }

 private:
  struct Held {
    PointerButton button;
    int x, y;        ///< where it went down
    int at_x, at_y;  ///< where it is
    bool on_slice;
  };

  DisplayConnection display_;
  QuietVtk quiet_;
  WindowModel& model_;
  SceneWindowOptions options_;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderWindowInteractor> interactor_;
  vtkNew<WindowStyle> style_;
  std::optional<WindowLoss> loss_;
  std::optional<ScenePanel> scene_, beside_;
  std::optional<SlicePanel> slice_;
  std::optional<StatusPanel> status_;
  std::optional<HelpPanel> help_;
  std::optional<Held> held_;
  bool draw_scene_ = true, draw_slice_ = true, draw_status_ = true;
  bool is_moving_ = false;  ///< fewer triangles are drawn
  double still_seconds_ = 0;
  double quiet_seconds_ = 0;  ///< since the last event
  std::uint64_t layout_seen_ = 0;
  std::string status_seen_;
  std::size_t events_ = 0;  ///< of this turn
  SceneWindowReport report_;

  bool press(int x, int y, PointerButton button) override;
  bool move(int x, int y) override;
  bool release(int x, int y) override;
  bool wheel(int x, int y, bool forward, bool control) override;
  void key(const std::string& symbol, bool control) override;
  void camera_moved() override;

  void lay_out();
  template <class Change>
  void for_each_cube(Change change);
  void update();
  bool scene_can_wait() const;
  void draw();
  void settle(double seconds);
  void set_moving(bool moving);
  void fit_depth();
  void save_picture(const std::filesystem::path& path);
  bool wait_for_event(int milliseconds) const;
  static void on_window_event(vtkObject* caller, unsigned long event, void* window, void* data);
};

}  // namespace isostack
