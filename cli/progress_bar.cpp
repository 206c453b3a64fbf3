#include "cli/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <string>

namespace isostack::cli {

bool stderr_is_terminal() { return isatty(STDERR_FILENO) != 0; }

void draw_progress(std::string_view stage, double fraction) {
  constexpr int width = 30;
  const int done = std::clamp(static_cast<int>(fraction * width), 0, width);
  fmt::print(stderr, "\r{:<12}[{:<{}}] {:3.0f} %", stage, std::string(static_cast<std::size_t>(done), '#'), width,
             100 * fraction);
}

void erase_progress() {
  if (stderr_is_terminal()) fmt::print(stderr, "\r\x1b[K");
}

}  // namespace isostack::cli
