#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "recon/geometry/progress.h"

namespace isostack::cli {

/// What every command has: the common options, where its result goes, and what to run once the
/// whole command line has been understood.
struct Session {
  bool json = false;             ///< machine-readable result on stdout
  bool quiet = false;            ///< no progress, no notes
  int threads = 0;               ///< 0: all
  std::filesystem::path report;  ///< empty: none
  std::filesystem::path record;  ///< pipeline to which the command is added; empty: none

  std::function<void()> run;  ///< set by the chosen command
  nlohmann::json result;      ///< filled by it
  std::string text;           ///< the same for people

  /// Reports to the terminal and stops on Ctrl-C.
  Progress progress() const;
  /// A remark on stderr ("note: ...") unless --quiet; also kept in the result under "notes".
  void note(const std::string& remark);
  /// Tells of a file that was written, in the text and under "outputs" of the result.
  void wrote(const std::filesystem::path& file);
  /// All that were.
  std::vector<std::string> written() const;
};

}  // namespace isostack::cli
