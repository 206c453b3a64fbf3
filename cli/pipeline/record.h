#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace isostack::cli {

/// Adds what was just done to the pipeline in `file`, or begins one: the command with its options as they were in
/// force, recipes resolved, and the files it wrote. A step that wrote the same files is replaced. What it read from
/// outside becomes an input, named after its file. Throws InputError when `file` is there and no pipeline.
void record_step(const CLI::App& command, const std::vector<std::string>& written, const std::filesystem::path& file);

}  // namespace isostack::cli
