#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/input_options.h"
#include "cli/session.h"
#include "recon/reconstruct.h"

namespace isostack::cli {

/// `measure --leave-out`: what to drop, what to reconstruct from the rest, where the plot goes.
struct LeaveOutCommand {
  std::vector<int> every;      ///< one study for each
  std::filesystem::path plot;  ///< empty: none
  ReconstructOptions options;
};

/// Adds the studies of every organ to the result and, as a table, to the text; writes the plot.
void run_leave_out(const LeaveOutCommand& command, const InputOptions& input, Session& session);

}  // namespace isostack::cli
