#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>

#include "cli/session.h"

namespace isostack::cli {

/// Standard input and output in place of files: `-`, or `FORMAT:-` such as `ply:-` where the data or the command do not
/// tell the format. The command works on files in a temporary folder, which is removed at the end.
class StandardStreams {
 public:
  /// Finds what the command line asks for. Throws CLI::ValidationError when a stream would have two uses or an output
  /// has no format.
  StandardStreams(CLI::App& command, const Session& session);
  ~StandardStreams();
  StandardStreams(const StandardStreams&) = delete;
  StandardStreams& operator=(const StandardStreams&) = delete;

  /// Reads standard input to its end, if it is asked for, and puts the files' paths in the options' places.
  /// Throws InputError when the format cannot be told, Cancelled.
  void open();
  /// Writes the output, if there is one, to standard output. Throws InputError when the command wrote several files.
  void close() const;

  bool take_output() const { return output_.option != nullptr; }
  /// `-` for the paths of the temporary files, in a message or result.
  std::string named(std::string text) const;

 private:
  struct Stream {
    CLI::Option* option = nullptr;  ///< null: not asked for
    std::string value;              ///< "-" or "FORMAT:-"
    std::string extension;          ///< with the dot; empty: by content
    std::filesystem::path file;
  };

  void make_folder();
  void read_input();

  Stream input_, output_;
  std::filesystem::path folder_;
};

}  // namespace isostack::cli
