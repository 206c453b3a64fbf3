#pragma once

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>

#include <optional>
#include <string>

#include "viewers/window/overlay.h"
#include "viewers/window/playback.h"

class vtkRenderWindow;

namespace isostack {

/// The strip of text at the window's bottom, with the morph's slider. Private to the window.
class StatusPanel {
 public:
  StatusPanel(bool dark, vtkRenderWindow& window);

  vtkRenderer& renderer() const { return *renderer_; }
  /// `morph`: its slider is shown when it has frames.
  void show(const std::string& text, const Playback& morph);
  /// The frame at a pixel of the window on the slider; nothing elsewhere.
  std::optional<std::ptrdiff_t> frame_at(int x, int y, const Playback& morph) const;

  static constexpr int height_pixels = 104;

 private:
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkTextActor> text_;
  Overlay slider_;
  Eigen::Vector3d ink_;
};

/// The list of keys over the whole window.
class HelpPanel {
 public:
  HelpPanel(bool dark, vtkRenderWindow& window);
  vtkRenderer& renderer() const { return *renderer_; }

 private:
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkTextActor> text_;
};

}  // namespace isostack
