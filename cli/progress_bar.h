#pragma once

#include <string_view>

namespace isostack::cli {

bool stderr_is_terminal();

/// Draws "solve      [#######         ]  45 %" over the previous one on stderr.
void draw_progress(std::string_view stage, double fraction);

/// Clears the line if stderr is a terminal.
void erase_progress();

}  // namespace isostack::cli
