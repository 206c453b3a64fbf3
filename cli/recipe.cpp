#include "cli/recipe.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include "io/atomic_file.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view format = "isostack-recipe";
constexpr int version = 1;

[[noreturn]] void refuse(const std::string& name, const std::string& problem) {
  throw InputError("recipe " + name, problem, "compare it with one that `segment --save-recipe FILE` writes");
}

Json parsed(const std::string& name, std::istream& text) {
  try {
    return Json::parse(text);
  } catch (const Json::exception&) {
    refuse(name, "it is not valid JSON");
  }
}

std::string text_of(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// The values as a command line has them: numbers of one array belong together, texts are repetitions.
std::vector<std::string> values_of(const Json& value, const std::string& name, const std::string& option) {
  if (!value.is_array()) {
    if (!value.is_string() && !value.is_number() && !value.is_boolean())
      refuse(name, "option '" + option + "' is neither a number, text, true nor an array of these");
    return {text_of(value)};
  }
  std::vector<std::string> texts;
  for (const Json& item : value) {
    if (!item.is_string() && !item.is_number()) refuse(name, "option '" + option + "' has a strange item in its array");
    texts.push_back(text_of(item));
  }
  const bool all_numbers = std::all_of(value.begin(), value.end(), [](const Json& item) { return item.is_number(); });
  if (!all_numbers || texts.size() < 2) return texts;
  std::string joined;
  for (const std::string& text : texts) joined += (joined.empty() ? "" : ",") + text;
  return {joined};
}

bool is_flag(const CLI::Option& option) { return option.get_expected_max() == 0; }

/// Of the command's own, not where it reads and writes nor what steers recipes.
bool belongs_into_recipe(const CLI::Option& option) {
  const std::vector<std::string>& names = option.get_lnames();
  constexpr std::array<std::string_view, 4> others = {"help", "output", "recipe", "save-recipe"};
  return !names.empty() && std::find(others.begin(), others.end(), names.front()) == others.end();
}

Json number_or_text(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return text;
  if (value == std::floor(value) && std::abs(value) < 1e15) return static_cast<std::int64_t>(value);
  return value;
}

Json json_of(const CLI::Option& option) {
  if (is_flag(option)) return true;
  const std::vector<std::string>& results = option.results();
  const bool is_list = option.get_delimiter() != '\0' && results.size() > 1;
  const bool is_repeated = option.get_expected_max() > 1 && option.get_delimiter() == '\0';
  if (!is_list && !is_repeated) return number_or_text(results.front());
  Json values = Json::array();
  for (const std::string& result : results) values.push_back(is_list ? number_or_text(result) : Json(result));
  return values;
}

}  // namespace

Json read_recipe(const std::string& name_or_file) {
  Json recipe;
  const auto& built_in = built_in_recipes();
  const auto known =
      std::find_if(built_in.begin(), built_in.end(), [&](const auto& r) { return r.name == name_or_file; });
  if (known != built_in.end()) {
    std::istringstream text{std::string(known->text)};
    recipe = parsed(name_or_file, text);
  } else {
    std::ifstream file(name_or_file);
    if (!file) {
      std::string names;
      for (const BuiltInRecipe& r : built_in) names += (names.empty() ? "" : ", ") + std::string(r.name);
      throw InputError("recipe " + name_or_file, "there is no such file", "give a file, or one of " + names);
    }
    recipe = parsed(name_or_file, file);
  }
  if (!recipe.is_object() || recipe.value("format", Json()) != format)
    refuse(name_or_file, "it is not an isostack recipe");
  if (recipe.value("version", Json()) != version) refuse(name_or_file, "its version is not 1");
  if (!recipe.contains("command") || !recipe["command"].is_string()) refuse(name_or_file, "it names no command");
  if (!recipe.contains("options")) recipe["options"] = Json::object();
  if (!recipe["options"].is_object()) refuse(name_or_file, "its options are not an object");
  return recipe;
}

void apply_recipe(const Json& recipe, const std::string& name, CLI::App& command) {
  if (recipe["command"] != command.get_name())
    refuse(name,
           "it is for the command '" + recipe["command"].get<std::string>() + "', not '" + command.get_name() + "'");
  std::vector<CLI::Option*> given;
  for (CLI::Option* option : command.get_options())
    if (option->count() > 0) given.push_back(option);
  const auto is_given = [&](CLI::Option* option) {
    return std::find(given.begin(), given.end(), option) != given.end();
  };
  for (const auto& [key, value] : recipe["options"].items()) {
    CLI::Option* option = command.get_option_no_throw("--" + key);
    if (!option || !belongs_into_recipe(*option)) refuse(name, "'" + key + "' is no option of " + command.get_name());
    const auto& excluded = option->get_excludes();
    if (is_given(option) || std::any_of(excluded.begin(), excluded.end(), is_given)) continue;
    if (value == false) continue;
    try {
      for (const std::string& text : values_of(value, name, key)) option->add_result(text);
      option->run_callback();
    } catch (const CLI::Error& error) {
      refuse(name, "option '" + key + "' has a value that will not do (" + error.what() + ")");
    }
  }
}

void write_recipe(const CLI::App& command, const std::filesystem::path& path) {
  Json recipe = {
      {"format", format}, {"version", version}, {"isostack", ISOSTACK_VERSION}, {"command", command.get_name()}};
  recipe["input"] = command.get_option("IN")->results();
  const std::vector<std::string> outputs = command.get_option("--output")->results();
  recipe["output"] = outputs.size() == 1 ? Json(outputs.front()) : Json(outputs);
  recipe["options"] = Json::object();
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0 && belongs_into_recipe(*option))
      recipe["options"][option->get_lnames().front()] = json_of(*option);
  write_whole_file(path, recipe.dump(2) + "\n");
}

std::vector<std::string> arguments_of(const Json& recipe, const std::string& name) {
  std::vector<std::string> arguments = {recipe["command"].get<std::string>()};
  if (!recipe.contains("input") || !recipe.contains("output"))
    refuse(name, "it has no input or output to run with; use it with `" + arguments.front() + " IN -o OUT --recipe`");
  for (const std::string& input : values_of(recipe["input"], name, "input")) arguments.push_back(input);
  for (const std::string& output : values_of(recipe["output"], name, "output"))
    arguments.insert(arguments.end(), {"-o", output});
  for (const auto& [key, value] : recipe["options"].items()) {
    if (value == false) continue;
    for (const std::string& text : values_of(value, name, key)) {
      arguments.push_back("--" + key);
      if (value != true) arguments.push_back(text);
    }
  }
  return arguments;
}

}  // namespace isostack::cli
