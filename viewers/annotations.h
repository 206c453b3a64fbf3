#pragma once

#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <string>

class vtkRenderer;
class vtkTextActor;

namespace isostack {

/// RGB in [0, 1]; the ground is that of the picture.
struct TextColours {
  Eigen::Vector3d ink, ground;
};

/// The title, centred at the top of the picture. Its size follows the renderer's height, and its width where it is
/// long.
class Title {
 public:
  Title(const TextColours& colours, vtkRenderer& renderer);
  void set(const std::string& title);

 private:
  vtkSmartPointer<vtkTextActor> text_;
};

/// Adds a bar of a round length in mm (1, 2 or 5 times a power of ten) at the bottom right; it follows the camera,
/// which must be in parallel projection.
void add_scale_bar(const TextColours& colours, vtkRenderer& renderer);

/// The longest round length that is at most `longest_mm` (> 0).
double round_length_mm(double longest_mm);

}  // namespace isostack
