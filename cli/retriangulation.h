#pragma once

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "recon/surface/retriangulate.h"

namespace isostack::cli {

/// --edge-length, --simplify and --triangles, for every command that makes surfaces.
void add_retriangulation_options(CLI::App& command, RetriangulationOptions& options);

nlohmann::json to_json(const std::optional<RetriangulationReport>& report);  ///< null when nothing was asked for
std::string to_text(const std::optional<RetriangulationReport>& report);

}  // namespace isostack::cli
