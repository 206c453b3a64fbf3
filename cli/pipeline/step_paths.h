#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/pipeline/pipeline.h"

namespace isostack::cli {

/// True for two ways to write one place, whether it is there or not.
bool is_same_path(const std::filesystem::path& a, const std::filesystem::path& b);

/// True for a file that the step writes, or a folder in which it writes some.
bool writes_path(const PipelineStep& step, const std::filesystem::path& path);

/// The values of the step's options that the command reads as paths; "@NAME" stays.
std::vector<std::string> paths_read(const PipelineStep& step, const CLI::App& command);

}  // namespace isostack::cli
