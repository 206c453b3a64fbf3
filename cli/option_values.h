#pragma once

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace isostack::cli {

// How the values of command line options stand in JSON: flags are true; an option of several numbers is an array of
// numbers; an option that is repeated an array of texts.

bool is_flag(const CLI::Option& option);

/// Of an option that was given.
nlohmann::ordered_json json_of(const CLI::Option& option);

/// A number where the text is one.
nlohmann::ordered_json number_or_text(const std::string& text);

/// The values as a command line has them: numbers of one array belong together ("1,2,3"), texts are repetitions. None
/// for a value that no option can have.
std::optional<std::vector<std::string>> argument_values(const nlohmann::ordered_json& value);

}  // namespace isostack::cli
