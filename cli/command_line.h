#pragma once

namespace isostack::cli {

/// The program from its arguments to its exit code, as main() calls it.
int run_command_line(int argc, char** argv);

}  // namespace isostack::cli
