#pragma once

#include <vector>

#include "cli/pipeline/pipeline.h"

namespace isostack::cli {

/// The steps so that each comes after those whose files it reads (`reads`: one list of paths for each step), else in
/// the given order. Throws InputError naming the steps of a circle.
std::vector<std::size_t> step_order(const Pipeline& pipeline, const std::vector<std::vector<std::string>>& reads);

}  // namespace isostack::cli
