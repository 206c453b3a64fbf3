#include "cli/standard_streams.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <span>

#include "cli/interrupt.h"
#include "cli/path_roles.h"
#include "io/content_extension.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/progress.h"

namespace isostack::cli {

namespace fs = std::filesystem;

namespace {

bool is_stream(const std::string& value) { return value == "-" || (value.size() > 2 && value.ends_with(":-")); }

/// ".ply" of "ply:-", empty for "-".
std::string extension_of(const std::string& value) {
  return value == "-" ? std::string() : "." + value.substr(0, value.size() - 2);
}

/// What a plain `-` means as output.
std::string default_extension(const std::string& command) {
  if (command == "segment") return ".json";
  if (command == "reconstruct") return ".ply";
  return {};
}

void replace_value(CLI::Option& option, const std::string& value, const std::string& replacement) {
  std::vector<std::string> values = option.results();
  std::replace(values.begin(), values.end(), value, replacement);
  option.clear();
  for (const std::string& each : values) option.add_result(each);
  option.run_callback();
}

/// Whatever there is to read, waiting for it; 0 at the end. Waits with poll, which a signal ends.
std::size_t read_some(std::span<char> buffer) {
  while (true) {
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    const int ready = ::poll(&input, 1, -1);
    if (interrupted()) throw Cancelled();
    if (ready < 0) continue;
    const ssize_t count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (count < 0) throw InputError("-", "standard input cannot be read", "pipe or redirect a file into it");
    return static_cast<std::size_t>(count);
  }
}

}  // namespace

StandardStreams::StandardStreams(CLI::App& command, const Session& session) {
  for (CLI::Option* option : command.get_options()) {
    const std::optional<PathRole> role = path_role(*option);
    if (!role) continue;
    for (const std::string& value : option->results()) {
      if (!is_stream(value)) continue;
      Stream& stream = *role == PathRole::kRead ? input_ : output_;
      if (stream.option) throw CLI::ValidationError(value, "standard input and output serve one file each");
      stream = {.option = option, .value = value, .extension = extension_of(value), .file = {}};
    }
  }
  if (!input_.option && !output_.option) return;
  if (!session.record.empty())
    throw CLI::ValidationError("--record", "standard input and output cannot be had again; name files");
  if (!output_.option) return;
  if (session.json) throw CLI::ValidationError("--json", "standard output already carries a file; use --report FILE");
  if (output_.extension.empty()) output_.extension = default_extension(command.get_name());
  if (output_.extension.empty())
    throw CLI::ValidationError(output_.value, "standard output needs a format here, such as ply:- or nii.gz:-");
  if (::isatty(STDOUT_FILENO) && output_.extension != ".json")
    throw CLI::ValidationError(output_.value, "standard output is a terminal; redirect it to a file or a program");
}

StandardStreams::~StandardStreams() {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

void StandardStreams::make_folder() {
  std::string pattern = (fs::temp_directory_path() / "isostack-XXXXXX").string();
  if (!::mkdtemp(pattern.data()))
    throw InputError(fs::temp_directory_path().string(), "no temporary folder can be made there",
                     "set TMPDIR to a folder that can be written to");
  folder_ = pattern;
}

void StandardStreams::read_input() {
  const fs::path file = folder_ / "stdin";
  std::ofstream copy(file, std::ios::binary);
  std::vector<char> buffer(1 << 20);
  std::string start;
  while (const std::size_t count = read_some(buffer)) {
    if (start.size() < 400) start.append(buffer.data(), std::min<std::size_t>(count, 400));
    copy.write(buffer.data(), static_cast<std::streamsize>(count));
  }
  copy.close();
  if (!copy) throw InputError(folder_.string(), "standard input does not fit there", "set TMPDIR to a larger folder");
  if (input_.extension.empty()) input_.extension = content_extension(start, fs::file_size(file));
  if (start.empty()) throw InputError("-", "standard input is empty", "pipe or redirect a file into it");
  if (input_.extension.empty())
    throw InputError("-", "standard input shows no known format", "name it, such as contour:-, or name the file");
  input_.file = file.string() + input_.extension;
  fs::rename(file, input_.file);
}

void StandardStreams::open() {
  if (!input_.option && !output_.option) return;
  make_folder();
  if (input_.option) {
    read_input();
    replace_value(*input_.option, input_.value, input_.file.string());
  }
  if (output_.option) {
    output_.file = folder_ / ("stdout" + output_.extension);
    replace_value(*output_.option, output_.value, output_.file.string());
  }
}

void StandardStreams::close() const {
  if (!output_.option) return;
  if (!fs::is_regular_file(output_.file))
    throw InputError(output_.value, "there are several files to write", "name a file; each gets its own ending");
  std::signal(SIGPIPE, SIG_IGN);  // a reader that stops early is an error to tell, not a sudden end
  std::cout << std::ifstream(output_.file, std::ios::binary).rdbuf() << std::flush;
  if (!std::cout) throw InputError(output_.value, "standard output does not take the file", "see what reads it");
}

std::string StandardStreams::named(std::string text) const {
  for (const Stream* stream : {&input_, &output_}) {
    const std::string path = stream->file.string();
    if (path.empty()) continue;
    for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path, at + 1))
      text.replace(at, path.size(), "-");
  }
  return text;
}

}  // namespace isostack::cli
