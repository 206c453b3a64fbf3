#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <vector>

#include "cli/pipeline/run_pipeline.h"

namespace isostack::cli {

/// A step with the program's command line made for it alone, as options keep their values from one use to the next.
struct PreparedStep {
  const PipelineStep* step = nullptr;
  std::unique_ptr<Session> session;
  std::unique_ptr<CLI::App> app;
  CLI::App* command = nullptr;
};

/// Finds the command and its options. Throws InputError naming the step's place when there are no such.
PreparedStep prepared(const PipelineStep& step, const AddCommands& add_commands, const Session& session);

/// Has the command understand its options; `inputs` gives the paths of "@NAME". Throws InputError when it refuses them.
void parse_arguments(PreparedStep& prepared, const std::map<std::string, PipelineInput>& inputs);

/// Options that the step did not give and whose defaults are others now.
std::vector<std::string> changed_defaults(const PreparedStep& prepared);

}  // namespace isostack::cli
