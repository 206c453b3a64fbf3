#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/progress.h"
#include "recon/geometry/stopwatch.h"

namespace isostack::cli {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File temporary_file() {
  File file(std::tmpfile(), std::fclose);
  if (!file) throw InputError("temporary folder", "no file can be made in it", "free some room, or set TMPDIR");
  return file;
}

std::string text_of(std::FILE* file) {
  std::string text;
  std::rewind(file);
  char part[4096];
  for (std::size_t count = 0; (count = std::fread(part, 1, sizeof part, file)) > 0;) text.append(part, count);
  return text;
}

std::vector<std::string> arguments_in(const std::string& line, int number) {
  const nlohmann::json value = nlohmann::json::parse(line, nullptr, false);
  const auto is_text = [](const nlohmann::json& word) { return word.is_string(); };
  if (!value.is_array() || value.empty() || !std::all_of(value.begin(), value.end(), is_text))
    throw InputError(fmt::format("standard input, line {}", number), "it is not a JSON array of texts",
                     "write a command as [\"info\", \"FOLDER\"]");
  return value.get<std::vector<std::string>>();
}

/// In the new process: the command with its own output, and no longer than the process that began it.
[[noreturn]] void run_as_child(std::vector<std::string> words, pid_t parent, std::FILE* out, std::FILE* err) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) std::_Exit(EXIT_FAILURE);
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(fileno(out), STDOUT_FILENO);
  dup2(fileno(err), STDERR_FILENO);
  words.insert(words.begin(), "isostack");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const int exit_code = run_command_line(static_cast<int>(words.size()), argv.data());
  std::cout.flush();
  std::fflush(nullptr);
  std::_Exit(exit_code);
}

nlohmann::json run_one(const std::vector<std::string>& words) {
  const File out = temporary_file(), err = temporary_file();
  const Stopwatch watch;
  std::fflush(nullptr);
  const pid_t parent = getpid(), child = fork();
  if (child < 0) throw InputError("batch", "no process can be started", "close other programs");
  if (child == 0) run_as_child(words, parent, out.get(), err.get());
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0)
    if (errno != EINTR) throw InputError("batch", "a process got lost", "run the command again");
  return {
      {"arguments", words},           {"exit_code", WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)},
      {"seconds", watch.seconds()},   {"peak_bytes", static_cast<std::size_t>(usage.ru_maxrss) * 1024},
      {"stdout", text_of(out.get())}, {"stderr", text_of(err.get())}};
}

void run_batch() {
  std::string line;
  for (int number = 1; std::getline(std::cin, line); ++number) {
    if (line.empty()) continue;
    const nlohmann::json result = run_one(arguments_in(line, number));
    if (interrupted()) throw Cancelled();
    const std::string text = result.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    fmt::print("{}\n", text);
    std::fflush(stdout);
  }
}

}  // namespace

void add_batch(CLI::App& app, Session& session) {
  CLI::App* command = app.add_subcommand(
      "batch", "Commands from standard input, a JSON array of words a line, each in a process of its own");
  command->callback([&session] { session.run = run_batch; });
}

}  // namespace isostack::cli
