#pragma once

#include <exception>
#include <nlohmann/json.hpp>
#include <string>

namespace isostack::cli {

enum ExitCode { kDone = 0, kWrongUsage = 2, kBadInput = 3, kCouldNotSolve = 4, kCancelled = 5 };

/// Why a command failed, as stderr and, with --json, stdout tell it (docs/schemas/error.schema.json).
struct Failure {
  ExitCode exit_code = kBadInput;
  std::string kind;                    ///< name of the exception
  std::string message;                 ///< one sentence
  std::string where, problem, remedy;  ///< its parts; empty where it has none
};

Failure failure_of(const std::exception& error);

/// The document's "error".
nlohmann::json to_json(const Failure& failure);

}  // namespace isostack::cli
