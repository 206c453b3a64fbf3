#pragma once

#include <memory>

namespace isostack {

/// A connection to the X server named by DISPLAY, which can draw with OpenGL. To be made before any VTK rendering
/// object, as VTK ends the process when it finds no server, and to be kept until the last one is gone: a virtual server
/// starts afresh when its last client leaves, and turns away who comes meanwhile.
class DisplayConnection {
 public:
  /// Throws InputError when no server answers or it lacks OpenGL.
  DisplayConnection();

 private:
  std::shared_ptr<void> display_;
};

}  // namespace isostack
