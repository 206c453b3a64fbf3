#pragma once

#include <CLI/App.hpp>
#include <string>

namespace isostack::cli {

/// Every command, argument and option in Markdown, from the program's option table: values, defaults, what options need
/// and exclude.
std::string options_page(const CLI::App& app);

}  // namespace isostack::cli
