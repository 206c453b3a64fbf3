#include <fmt/format.h>
#include <malloc.h>
#include <oneapi/tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string_view>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/completions.h"
#include "cli/failure.h"
#include "cli/interrupt.h"
#include "cli/manual_page.h"
#include "cli/options_page.h"
#include "cli/pipeline/pipeline.h"
#include "cli/pipeline/record.h"
#include "cli/progress_bar.h"
#include "cli/standard_streams.h"
#include "io/atomic_file.h"
#include "recon/geometry/errors.h"
#include "recon/solvers/thread_count.h"

namespace {

using isostack::cli::kDone;
using isostack::cli::kWrongUsage;

constexpr const char* description = "isostack " ISOSTACK_VERSION
                                    ": from stacks of medical image slices to one smooth closed surface.\n"
                                    "Research software. Not a medical device, not for clinical use.";

/// Before any work: a run that cannot be recorded would have to be done again.
void require_recordable(const CLI::App& command, const isostack::cli::Session& session) {
  if (session.record.empty()) return;
  if (command.get_name() == "run")
    throw isostack::InputError("--record", "`run` is what a recorded pipeline is for",
                               "record the commands themselves");
  if (std::filesystem::exists(session.record)) isostack::cli::read_pipeline(session.record);
}

void run(const CLI::App& command, isostack::cli::Session& session, isostack::cli::StandardStreams& streams) {
  require_recordable(command, session);
  streams.open();
  const auto threads = static_cast<std::size_t>(session.threads > 0 ? session.threads : isostack::available_threads());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  session.run();
  isostack::cli::erase_progress();
  if (!session.record.empty()) isostack::cli::record_step(command, session.written(), session.record);
  session.result["isostack"] = ISOSTACK_VERSION;
  const std::string result = streams.named(session.result.dump(2) + "\n");
  if (!session.report.empty()) isostack::write_whole_file(session.report, result);
  streams.close();
  if (streams.take_output() && session.quiet) return;
  fmt::print(streams.take_output() ? stderr : stdout, "{}", session.json ? result : streams.named(session.text));
}

/// The message on stderr; with --json also as a document where the result would be.
int fail(const isostack::cli::Failure& failure, const isostack::cli::Session& session,
         const isostack::cli::StandardStreams& streams) {
  isostack::cli::erase_progress();
  fmt::print(stderr, "isostack: {}\n", streams.named(failure.message));
  if (session.json) {
    nlohmann::json document = {{"error", to_json(failure)}, {"isostack", ISOSTACK_VERSION}};
    if (session.result.contains("notes")) document["notes"] = session.result["notes"];
    fmt::print(streams.take_output() ? stderr : stdout, "{}", streams.named(document.dump(2) + "\n"));
  }
  return failure.exit_code;
}

int run_and_translate_errors(const CLI::App& command, isostack::cli::Session& session,
                             isostack::cli::StandardStreams& streams) {
  try {
    run(command, session, streams);
    return kDone;
  } catch (const std::exception& error) {
    return fail(isostack::cli::failure_of(error), session, streams);
  }
}

/// What CLI11 says goes to stderr; with --json also to stdout as a document.
int refuse_usage(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  if (app.exit(error) == 0) return kDone;
  if (std::find(argv, argv + argc, std::string_view("--json")) != argv + argc) {
    const isostack::cli::Failure failure{kWrongUsage, "UsageError", error.what(), "", "", ""};
    fmt::print("{}\n", nlohmann::json{{"error", to_json(failure)}, {"isostack", ISOSTACK_VERSION}}.dump(2));
  }
  return kWrongUsage;
}

}  // namespace

int isostack::cli::run_command_line(int argc, char** argv) {
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
    page = kind == "man"        ? isostack::cli::manual_page(app)
           : kind == "markdown" ? isostack::cli::options_page(app)
           : kind == "bash"     ? isostack::cli::bash_completions(app)
                                : isostack::cli::zsh_completions(app);
    throw CLI::Success();
  };
  app.add_option_function<std::string>("--generate", print,
                                       "Print the manual page, the page of all options, or completions for a shell")
      ->check(CLI::IsMember({"man", "markdown", "bash", "zsh"}))
      ->trigger_on_parse();
  std::optional<isostack::cli::StandardStreams> streams;
  try {
    app.parse(argc, argv);
    streams.emplace(*app.get_subcommands().front(), session);
  } catch (const CLI::ParseError& error) {
    fmt::print("{}", page);
    return refuse_usage(app, error, argc, argv);
  }
  return run_and_translate_errors(*app.get_subcommands().front(), session, *streams);
}

int main(int argc, char** argv) {
  // Large blocks go back to the system once they are freed, so that the program's peak is what it needs at one time.
  mallopt(M_MMAP_THRESHOLD, 4 << 20);
  mallopt(M_TRIM_THRESHOLD, 32 << 20);
  isostack::cli::watch_for_interrupts();
  return isostack::cli::run_command_line(argc, argv);
}
