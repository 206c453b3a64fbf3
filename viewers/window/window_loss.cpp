#include "viewers/window/window_loss.h"

#include <X11/Xlib.h>

#include <atomic>
#include <cstdint>

namespace isostack {

namespace {

// Xlib's handlers know no owner but the process.
std::atomic<bool> is_lost = false;
XErrorHandler error_handler_before = nullptr;
XIOErrorHandler io_error_handler_before = nullptr;

/// Whatever the error is, what the window shows from now on means nothing.
int note_error(Display* /*display*/, XErrorEvent* /*error*/) {
  is_lost = true;
  return 0;
}

int note_io_error(Display* /*display*/) {
  is_lost = true;
  return 0;
}

void go_on(Display* /*display*/, void* /*data*/) {}

}  // namespace

WindowLoss::WindowLoss(void* display, void* window) : display_(display), window_(window) {
  is_lost = false;
  error_handler_before = XSetErrorHandler(note_error);
  io_error_handler_before = XSetIOErrorHandler(note_io_error);
  XSetIOErrorExitHandler(static_cast<Display*>(display), go_on, nullptr);
}

WindowLoss::~WindowLoss() {
  XSetErrorHandler(error_handler_before);
  XSetIOErrorHandler(io_error_handler_before);
}

bool WindowLoss::has_happened() const {
  XEvent event;
  const auto window = static_cast<Window>(reinterpret_cast<std::uintptr_t>(window_));
  if (!is_lost && XCheckTypedWindowEvent(static_cast<Display*>(display_), window, DestroyNotify, &event))
    is_lost = true;
  return is_lost;
}

}  // namespace isostack
