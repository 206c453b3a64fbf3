#pragma once

#include <CLI/App.hpp>

#include "cli/session.h"

namespace isostack::cli {

// Each adds its subcommand with its options; when chosen, it sets session.run.
void add_info(CLI::App& app, Session& session);
void add_segment(CLI::App& app, Session& session);
void add_reconstruct(CLI::App& app, Session& session);
void add_measure(CLI::App& app, Session& session);
void add_morph(CLI::App& app, Session& session);
void add_view(CLI::App& app, Session& session);
void add_convert(CLI::App& app, Session& session);
void add_run(CLI::App& app, Session& session);
void add_batch(CLI::App& app, Session& session);

/// All of them.
void add_commands(CLI::App& app, Session& session);

}  // namespace isostack::cli
