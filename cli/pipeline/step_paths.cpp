#include "cli/pipeline/step_paths.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/path_roles.h"

namespace isostack::cli {

namespace {

namespace fs = std::filesystem;

fs::path normal(const fs::path& path) {
  fs::path result = fs::absolute(path).lexically_normal();
  return result.has_filename() ? result : result.parent_path();  // "folder/" is "folder"
}

}  // namespace

bool is_same_path(const fs::path& a, const fs::path& b) { return normal(a) == normal(b); }

bool writes_path(const PipelineStep& step, const fs::path& path) {
  const fs::path place = normal(path);
  return std::any_of(step.writes.begin(), step.writes.end(), [&](const std::string& written) {
    const fs::path relative = normal(written).lexically_relative(place);
    return !relative.empty() && *relative.begin() != "..";
  });
}

std::vector<std::string> paths_read(const PipelineStep& step, const CLI::App& command) {
  std::vector<std::string> paths;
  for (const CLI::Option* option : command.get_options()) {
    const auto value = step.options.find(option_key(*option));
    if (value == step.options.end() || path_role(*option) != PathRole::kRead) continue;
    for (const auto& text : value->is_array() ? *value : nlohmann::ordered_json::array({*value}))
      if (text.is_string()) paths.push_back(text);
  }
  return paths;
}

}  // namespace isostack::cli
