#pragma once

#include <CLI/App.hpp>
#include <string>

namespace isostack::cli {

/// The program's manual page (isostack.1, in man's roff) from its option table: every command, option and argument.
std::string manual_page(const CLI::App& app);

}  // namespace isostack::cli
