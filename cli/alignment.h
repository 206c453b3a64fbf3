#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/session.h"
#include "recon/constraints/align.h"
#include "recon/constraints/crossings.h"
#include "recon/geometry/contour.h"

namespace isostack::cli {

/// --align and what belongs to it.
struct AlignmentCommand {
  bool align = false;
  AlignOptions options;
  std::filesystem::path aligned;  ///< where the moved contours go; empty: nowhere
};

void add_alignment_options(CLI::App& command, AlignmentCommand& alignment);

/// Each organ's slices moved in their planes, if asked for, and described in the result under "alignments"; organs
/// unchanged otherwise.
std::vector<ContourStack> aligned(std::vector<ContourStack> organs, const AlignmentCommand& command, Session& session);

/// Per pair of slices: names, lengths and places; with the sum and the largest.
nlohmann::json to_json(const Contradictions& contradictions);

/// The pairs that disagree most, ten at most, as a table; empty when none disagrees by `least_mm`.
std::string to_text(const Contradictions& contradictions, double least_mm);

}  // namespace isostack::cli
