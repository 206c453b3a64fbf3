#pragma once

#include <functional>
#include <string_view>

namespace isostack {

/// How long work reports where it is and learns that it should stop.
/// Default-constructed it is silent and never cancels. Both functions are
/// called from the thread that started the work only.
struct Progress {
  /// Stage is a short noun ("solve"); fraction of that stage is in [0, 1].
  std::function<void(std::string_view stage, double fraction)> on_report;
  std::function<bool()> is_cancelled;

  /// Reports, then throws Cancelled if the caller asked to stop.
  void report(std::string_view stage, double fraction) const;
};

}  // namespace isostack
