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

void Session::wrote(const std::filesystem::path& file) {
  result["outputs"].push_back(file.string());
  text += "wrote " + file.string() + "\n";
}

std::vector<std::string> Session::written() const {
  return result.contains("outputs") ? result["outputs"].get<std::vector<std::string>>() : std::vector<std::string>();
}

}  // namespace isostack::cli
