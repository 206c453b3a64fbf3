#include "viewers/window/view_session.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/atomic_file.h"
#include "recon/geometry/errors.h"
#include "viewers/window/view_session_json.h"

namespace isostack {

namespace {

using Json = nlohmann::json;
using Path = std::filesystem::path;
constexpr const char* format_name = "isostack-view";
constexpr int format_version = 1;
constexpr const char* remedy = "see docs/schemas/view-session.schema.json for what a session looks like";

/// Relative to the folder where that is possible, so that a session and its files can move together.
Json paths_json(const std::vector<Path>& paths, const Path& folder) {
  Json list = Json::array();
  for (const Path& path : paths) {
    const Path relative = std::filesystem::absolute(path).lexically_normal().lexically_relative(folder);
    list.push_back((relative.empty() ? path : relative).generic_string());
  }
  return list;
}

std::vector<Path> paths_from(const Json& json, const char* key, const Path& folder) {
  std::vector<Path> paths;
  if (!json.contains(key)) return paths;
  for (const Json& path : json[key]) paths.push_back((folder / path.get<std::string>()).lexically_normal());
  return paths;
}

Path folder_of(const Path& path) { return std::filesystem::absolute(path).lexically_normal().parent_path(); }

/// What the library says, without its own name and number.
std::string essence_of(const Json::exception& error) {
  const std::string text = error.what();
  const auto end = text.find("] ");
  return end == std::string::npos ? text : text.substr(end + 2);
}

}  // namespace

bool is_view_session(const Path& path) {
  if (path.extension() != ".json") return false;
  std::ifstream stream(path);
  const Json document = Json::parse(stream, nullptr, false);
  return document.is_object() && document.contains("format") && document["format"] == format_name;
}

ViewSession read_view_session(const Path& path) {
  std::ifstream stream(path);
  try {
    const Json document = Json::parse(stream);
    if (!document.is_object() || document.value("format", "") != format_name ||
        document.value("version", 0.0) != format_version)
      throw InputError(path.string(),
                       fmt::format("it is not \"format\": \"{}\", \"version\": {}", format_name, format_version),
                       remedy);
    ViewSession session;
    const Path folder = folder_of(path);
    session.inputs = paths_from(document, "inputs", folder);
    session.frames = paths_from(document, "frames", folder);
    session.beside = paths_from(document, "beside", folder);
    session.title = document.value("title", "");
    session.dark = document.value("dark", false);
    if (session.inputs.empty() && session.frames.empty()) throw InputError(path.string(), "it names no input", remedy);
    if (document.contains("state")) session.state = view_state_from(document["state"]);
    return session;
  } catch (const Json::exception& error) {
    throw InputError(path.string(), "it does not hold a session as expected (" + essence_of(error) + ")", remedy);
  }
}

void write_view_session(const ViewSession& session, const Path& path) {
  const Path folder = folder_of(path);
  const Json document = {{"format", format_name},
                         {"version", format_version},
                         {"inputs", paths_json(session.inputs, folder)},
                         {"frames", paths_json(session.frames, folder)},
                         {"beside", paths_json(session.beside, folder)},
                         {"title", session.title},
                         {"dark", session.dark},
                         {"state", to_json(session.state)}};
  write_whole_file(path, document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace isostack
