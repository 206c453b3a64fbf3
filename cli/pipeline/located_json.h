#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace isostack::cli {

/// A JSON document that remembers where in its file every value stands, for messages.
struct LocatedJson {
  std::filesystem::path file;
  nlohmann::ordered_json value;
  std::map<std::string, int> lines;  ///< by JSON pointer ("/steps/0/command"), from 1

  /// "runs.json, line 12": of the value there, or of the nearest one round it that is known.
  std::string where(const std::string& pointer = "") const;
};

/// Throws InputError naming file and line when the file is missing or not valid JSON, or a key stands twice.
LocatedJson read_located_json(const std::filesystem::path& file);

}  // namespace isostack::cli
