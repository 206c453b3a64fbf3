#include "cli/pipeline/run_state.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/pipeline/content_hash.h"
#include "io/atomic_file.h"

namespace isostack::cli {

namespace {

using Json = nlohmann::ordered_json;
constexpr const char* state_format = "isostack-pipeline-state";

}  // namespace

RunState::RunState(std::filesystem::path file) : file_(std::move(file)) {
  std::ifstream stream(file_);
  const Json json = Json::parse(stream, nullptr, false);
  if (!json.is_object() || json.value("format", "") != state_format) return;
  try {
    for (const auto& [name, step] : json.at("steps").items())
      entries_[name] = {step.at("key"), step.at("outputs").get<std::map<std::string, std::string>>()};
  } catch (const Json::exception&) {
    entries_.clear();
  }
}

bool RunState::is_current(const std::string& step, const std::string& key) const {
  const auto entry = entries_.find(step);
  if (entry == entries_.end() || entry->second.key != key) return false;
  return std::all_of(entry->second.outputs.begin(), entry->second.outputs.end(), [](const auto& output) {
    return std::filesystem::exists(output.first) && output_hash(output.first) == output.second;
  });
}

std::vector<std::string> RunState::written(const std::string& step) const {
  std::vector<std::string> paths;
  if (const auto entry = entries_.find(step); entry != entries_.end())
    for (const auto& [path, hash] : entry->second.outputs) paths.push_back(path);
  return paths;
}

void RunState::remember(const std::string& step, const std::string& key, const std::vector<std::string>& written) {
  Entry entry{key, {}};
  for (const std::string& path : written) entry.outputs[path] = output_hash(path);
  entries_[step] = std::move(entry);
  write();
}

void RunState::forget(const std::string& step) {
  if (entries_.erase(step) > 0) write();
}

void RunState::write() const {
  Json json = {{"format", state_format}, {"version", 1}, {"steps", Json::object()}};
  for (const auto& [name, entry] : entries_) json["steps"][name] = {{"key", entry.key}, {"outputs", entry.outputs}};
  write_whole_file(file_, json.dump(2) + "\n");
}

}  // namespace isostack::cli
