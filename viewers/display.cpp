#include "viewers/display.h"

#include <X11/Xlib.h>

#include <chrono>
#include <cstdlib>
#include <string_view>
#include <thread>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// Tries for half a second, as a virtual server may be about to start afresh.
Display* open_display() {
  const char* name = std::getenv("DISPLAY");
  if (name == nullptr || std::string_view(name).empty()) return nullptr;
  for (int attempt = 0; attempt < 10; ++attempt) {
    if (Display* display = XOpenDisplay(nullptr)) return display;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return nullptr;
}

}  // namespace

DisplayConnection::DisplayConnection() {
  Display* display = open_display();
  if (display == nullptr)
    throw InputError("display", "there is no display to draw with",
                     "run it under xvfb-run, or set DISPLAY to a running X server");
  display_.reset(display, [](Display* opened) { XCloseDisplay(opened); });
  int opcode = 0, first_event = 0, first_error = 0;
  if (!XQueryExtension(display, "GLX", &opcode, &first_event, &first_error))
    throw InputError("display", "its X server cannot draw with OpenGL (no GLX)", "run it under xvfb-run");
}

}  // namespace isostack
