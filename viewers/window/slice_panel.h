#pragma once

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>

#include "viewers/slice_actor.h"
#include "viewers/window/overlay.h"
#include "viewers/window/window_model.h"

class vtkRenderWindow;

namespace isostack {

/// The shown slice as a flat picture: columns to the right, rows downwards. Private to the window.
class SlicePanel {
 public:
  SlicePanel(bool dark, vtkRenderWindow& window);

  vtkRenderer& renderer() const { return *renderer_; }
  /// True when something has changed and must be drawn.
  bool update(WindowModel& model);

  bool contains(int x, int y) const;
  /// The place at a pixel of the window, slice coordinates; only with a plane shown.
  Eigen::Vector2d place_at(int x, int y) const;
  double mm_per_pixel() const;
  void zoom(double factor);
  void pan(int pixels_right, int pixels_up);
  /// Everything into view.
  void fit();
  /// Has all kinds of marks drawn with the next picture: the graphics library prepares each when it first meets it,
  /// which takes a tenth of a second.
  void warm_up();

 private:
  vtkNew<vtkRenderer> renderer_;
  SliceActor image_;
  Overlay overlay_;
  std::array<vtkSmartPointer<vtkTextActor>, 4> letters_;  ///< left, right, top, bottom
  std::optional<ViewPlane> plane_;
  Eigen::AlignedBox2d framed_mm_;
  Eigen::Vector2d centre_mm_ = Eigen::Vector2d::Zero();
  double height_mm_ = 1;    ///< of what is in view
  bool has_image_ = false;  ///< the two below hold
  std::optional<std::size_t> image_index_;
  GreyWindow grey_;
  std::uint64_t slice_revision_ = 0, grey_revision_ = 0;

  void show_plane(const ViewPlane& plane);
  void show_image(const WindowModel& model);
  void draw_curves(WindowModel& model);
  void draw_marks(const WindowModel& model);
  void place_camera();
  void place_letters();
};

}  // namespace isostack
