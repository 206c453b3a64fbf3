#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "viewers/scene_view.h"
#include "viewers/window/overlay.h"
#include "viewers/window/window_model.h"

namespace isostack {

/// A scene of the model in 3D, with cut lines, picks and seeds. Private to the window.
class ScenePanel {
 public:
  enum class Which { result, beside };
  ScenePanel(const WindowModel& model, Which which, const SceneLook& look, vtkRenderWindow& window);

  SceneView& view() { return view_; }
  vtkRenderer& renderer() const { return view_.renderer(); }
  /// True when something has changed and must be drawn.
  bool update(WindowModel& model);

  bool contains(int x, int y) const;
  Ray ray_at(int x, int y) const;
  ViewCamera camera() const;
  void set_camera(const ViewCamera& camera);
  void set_moving(bool moving);
  /// As SlicePanel's.
  void warm_up();

 private:
  Which which_;
  SceneView view_;
  Overlay overlay_;
  std::array<std::uint64_t, static_cast<std::size_t>(WindowPart::count)> seen_{};
  std::vector<std::uint64_t> seen_surfaces_;
  ClipPlane clip_;

  const Scene& scene_of(const WindowModel& model) const;
  bool is_new(const WindowModel& model, WindowPart part);
  bool update_surfaces(const WindowModel& model);
  void draw_marks(WindowModel& model);
  void clip_items();
};

}  // namespace isostack
