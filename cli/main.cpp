#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <new>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/progress_bar.h"
#include "io/atomic_file.h"
#include "recon/geometry/errors.h"
#include "recon/solvers/thread_count.h"

namespace {

enum ExitCode { kDone = 0, kWrongUsage = 2, kBadInput = 3, kCouldNotSolve = 4, kCancelled = 5 };

constexpr const char* description = "isostack " ISOSTACK_VERSION
                                    ": from stacks of medical image slices to one smooth closed surface.\n"
                                    "Research software. Not a medical device, not for clinical use.";

int fail(ExitCode code, const std::string& message) {
  isostack::cli::erase_progress();
  fmt::print(stderr, "isostack: {}\n", message);
  return code;
}

void run(isostack::cli::Session& session) {
  const auto threads = static_cast<std::size_t>(session.threads > 0 ? session.threads : isostack::available_threads());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  isostack::set_linear_algebra_threads(static_cast<int>(threads));
  session.run();
  isostack::cli::erase_progress();
  session.result["isostack"] = ISOSTACK_VERSION;
  if (!session.report.empty()) isostack::write_whole_file(session.report, session.result.dump(2) + "\n");
  fmt::print("{}", session.json ? session.result.dump(2) + "\n" : session.text);
}

int run_and_translate_errors(isostack::cli::Session& session) {
  try {
    run(session);
    return kDone;
  } catch (const isostack::SolveError& error) {
    return fail(kCouldNotSolve, error.what());
  } catch (const isostack::Error& error) {
    return fail(kBadInput, error.what());
  } catch (const isostack::Cancelled&) {
    return fail(kCancelled, "stopped; no output was written");
  } catch (const std::bad_alloc&) {
    return fail(kCouldNotSolve, "memory: there is not enough of it; use fewer constraints or a coarser --resolution.");
  } catch (const std::exception& error) {
    return fail(kBadInput, fmt::format("unexpected failure: {}; please report how it came about.", error.what()));
  }
}

}  // namespace

int main(int argc, char** argv) {
  isostack::cli::watch_for_interrupts();
  isostack::cli::Session session;
  CLI::App app(description, "isostack");
  app.require_subcommand(1);
  app.fallthrough();
  app.set_version_flag("--version", ISOSTACK_VERSION);
  app.add_flag("--json", session.json, "Print the result as JSON");
  app.add_option("--report", session.report, "Write the result as JSON to this file")->type_name("FILE");
  app.add_option("--threads", session.threads, "Threads to use (0: all)")->check(CLI::NonNegativeNumber);
  app.add_flag("--quiet", session.quiet, "No progress bar, no notes");
  isostack::cli::add_info(app, session);
  isostack::cli::add_segment(app, session);
  isostack::cli::add_reconstruct(app, session);
  isostack::cli::add_measure(app, session);
  isostack::cli::add_view(app, session);
  isostack::cli::add_convert(app, session);
  isostack::cli::add_morph(app, session);
  isostack::cli::add_run(app, session);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kWrongUsage;
  }
  return run_and_translate_errors(session);
}
