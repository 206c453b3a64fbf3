#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "cli/pipeline/pipeline.h"
#include "cli/session.h"

namespace isostack::cli {

struct PipelineRunOptions {
  std::map<std::string, std::string> inputs;  ///< other paths for named inputs
  std::filesystem::path output_folder;        ///< outputs go below it; empty: where they were written before
  bool force = false;                         ///< also steps whose inputs, options and outputs have not changed
  bool dry_run = false;                       ///< only tell what would run
};

/// Gives an App all commands of the program.
using AddCommands = std::function<void(CLI::App&, Session&)>;

/// Runs the steps, each after those whose files it reads. A step is kept when program, options, content of what it
/// reads and of what it wrote are those of the last run, remembered in `FILE.state.json` (beside the pipeline, or in
/// the output folder) after every step: an interrupted run goes on where it was. The session's result tells of every
/// step.
///
/// Throws InputError, naming file and line, for steps that cannot be understood or inputs that are missing, before
/// anything runs; and what the step throws that fails.
void run_pipeline(const std::filesystem::path& file, const PipelineRunOptions& options, const AddCommands& add_commands,
                  Session& session);

}  // namespace isostack::cli
