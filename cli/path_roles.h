#pragma once

#include <CLI/App.hpp>
#include <optional>

namespace isostack::cli {

/// What the paths of an option are for: told in the option table itself, for recorded runs and completions.
enum class PathRole { kRead, kWritten };

/// Marks an option whose values are files or folders that are read: `add_option(...)->check(read_path())`.
CLI::Validator read_path();
/// The same of files or folders that are written.
CLI::Validator written_path();

/// None for an option whose values are not paths.
std::optional<PathRole> path_role(const CLI::Option& option);

/// The name that recorded runs know an option by: without dashes, positional ones as they stand ("IN").
std::string option_key(const CLI::Option& option);

}  // namespace isostack::cli
