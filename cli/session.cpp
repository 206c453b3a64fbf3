#include "cli/session.h"

#include <fmt/format.h>

#include "cli/interrupt.h"
#include "cli/progress_bar.h"

namespace isostack::cli {

Progress Session::progress() const {
  Progress progress;
  if (!quiet && stderr_is_terminal()) progress.on_report = draw_progress;
  progress.is_cancelled = interrupted;
  return progress;
}

void Session::note(const std::string& remark) {
  result["notes"].push_back(remark);
  if (quiet) return;
  erase_progress();
  fmt::print(stderr, "note: {}\n", remark);
}

}  // namespace isostack::cli
