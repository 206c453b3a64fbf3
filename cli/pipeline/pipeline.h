#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace isostack::cli {

/// A file or folder from outside that a pipeline reads. Steps name it as "@NAME".
struct PipelineInput {
  std::string path;
  std::string sha256;  ///< content_hash when it was recorded; empty: unknown
};

/// One command with its options, by their long names; arguments without a name by that in the help text ("IN").
struct PipelineStep {
  std::string name;  ///< unique in its pipeline
  std::string command;
  nlohmann::ordered_json options;   ///< what was given, recipes resolved; values as in option_values.h
  nlohmann::ordered_json defaults;  ///< of the options that were not, when it was recorded
  std::vector<std::string> writes;  ///< the files that came out
  std::string where;                ///< "FILE, line N", for messages
};

/// Commands that were run one after the other, to be run again (docs/schemas/pipeline.schema.json).
struct Pipeline {
  std::string isostack;  ///< version of the program that recorded it
  std::map<std::string, PipelineInput> inputs;
  std::vector<PipelineStep> steps;
};

/// Throws InputError naming file and line: not JSON, another format or version, unknown or missing keys, values of the
/// wrong kind, two steps of one name, "@NAME" without such an input.
Pipeline read_pipeline(const std::filesystem::path& file);

/// Written whole or not at all.
void write_pipeline(const Pipeline& pipeline, const std::filesystem::path& file);

/// The name in "@NAME"; empty for any other text.
std::string input_name(const std::string& text);

}  // namespace isostack::cli
