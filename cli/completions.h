#pragma once

#include <CLI/App.hpp>
#include <string>

namespace isostack::cli {

// What a shell offers after Tab, from the program's option table: commands, options, the values of options that have
// a fixed set, files and folders where paths are asked for.

/// A script for bash-completion.
std::string bash_completions(const CLI::App& app);

/// A function for zsh's fpath, named _isostack.
std::string zsh_completions(const CLI::App& app);

}  // namespace isostack::cli
