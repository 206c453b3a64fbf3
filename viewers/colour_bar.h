#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "viewers/scene.h"

class vtkRenderer;

namespace isostack {

/// Bars at the right of the picture, one for each kind of values that a visible surface shows, with round numbers
/// beside and the label above. Sizes follow the renderer's height.
class ColourBars {
 public:
  /// `ink`: colour of the texts.
  ColourBars(const Eigen::Vector3d& ink, vtkRenderer& renderer);
  ~ColourBars();
  ColourBars(const ColourBars&) = delete;
  ColourBars& operator=(const ColourBars&) = delete;

  void update(const std::vector<SceneSurface>& surfaces);
  /// What they take of the picture's width, in its heights.
  double width_in_heights() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isostack
