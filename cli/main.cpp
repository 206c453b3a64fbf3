#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <new>

#include "cli/commands.h"
#include "cli/completions.h"
#include "cli/interrupt.h"
#include "cli/manual_page.h"
#include "cli/pipeline/pipeline.h"
#include "cli/pipeline/record.h"
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

/// Before any work: a run that cannot be recorded would have to be done again.
void require_recordable(const CLI::App& command, const isostack::cli::Session& session) {
  if (session.record.empty()) return;
  if (command.get_name() == "run")
    throw isostack::InputError("--record", "`run` is what a recorded pipeline is for",
                               "record the commands themselves");
  if (std::filesystem::exists(session.record)) isostack::cli::read_pipeline(session.record);
}

void run(const CLI::App& command, isostack::cli::Session& session) {
  require_recordable(command, session);
  const auto threads = static_cast<std::size_t>(session.threads > 0 ? session.threads : isostack::available_threads());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  isostack::set_linear_algebra_threads(static_cast<int>(threads));
  session.run();
  isostack::cli::erase_progress();
  if (!session.record.empty()) isostack::cli::record_step(command, session.written(), session.record);
  session.result["isostack"] = ISOSTACK_VERSION;
  if (!session.report.empty()) isostack::write_whole_file(session.report, session.result.dump(2) + "\n");
  fmt::print("{}", session.json ? session.result.dump(2) + "\n" : session.text);
}

int run_and_translate_errors(const CLI::App& command, isostack::cli::Session& session) {
  try {
    run(command, session);
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
  app.add_option("--record", session.record, "Add this command to a pipeline file, for `run`")->type_name("FILE");
  isostack::cli::add_commands(app, session);
  std::string page;
  const auto print = [&](const std::string& kind) {
    page = kind == "man"    ? isostack::cli::manual_page(app)
           : kind == "bash" ? isostack::cli::bash_completions(app)
                            : isostack::cli::zsh_completions(app);
    throw CLI::Success();
  };
  app.add_option_function<std::string>("--generate", print, "Print the manual page, or completions for a shell")
      ->check(CLI::IsMember({"man", "bash", "zsh"}))
      ->trigger_on_parse();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    fmt::print("{}", page);
    return app.exit(error) == 0 ? kDone : kWrongUsage;
  }
  return run_and_translate_errors(*app.get_subcommands().front(), session);
}
