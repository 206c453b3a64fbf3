#include "cli/commands.h"

#include <CLI/CLI.hpp>

namespace isostack::cli {

void add_commands(CLI::App& app, Session& session) {
  add_info(app, session);
  add_segment(app, session);
  add_reconstruct(app, session);
  add_measure(app, session);
  add_view(app, session);
  add_convert(app, session);
  add_morph(app, session);
  add_run(app, session);
  add_batch(app, session);
}

}  // namespace isostack::cli
