#pragma once

namespace isostack {

/// While it lives a window that the X server takes away, for instance because another program destroyed it, does not
/// end the process, as Xlib would have it, but is told. One at a time. Private to the window.
class WindowLoss {
 public:
  /// `display` and `window`: X's Display* and number of the window, as VTK gives them.
  WindowLoss(void* display, void* window);
  ~WindowLoss();
  WindowLoss(const WindowLoss&) = delete;
  WindowLoss& operator=(const WindowLoss&) = delete;

  /// True once the window or the connection to the server is gone: drawing means nothing any more.
  bool has_happened() const;

 private:
  void* display_;
  void* window_;
};

}  // namespace isostack
