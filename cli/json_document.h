#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace isostack::cli {

/// The JSON object in a file that must say {"format": `format`, "version": 1, ...}. Throws InputError naming the file,
/// with `remedy`, when it is missing, no JSON or something else.
nlohmann::json read_json_document(const std::filesystem::path& path, const std::string& format,
                                  const std::string& remedy);

}  // namespace isostack::cli
