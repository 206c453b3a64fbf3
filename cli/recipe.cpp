#include "cli/recipe.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "cli/option_values.h"
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

std::vector<std::string> recipe_values(const Json& value, const std::string& name, const std::string& option) {
  const std::optional<std::vector<std::string>> texts = argument_values(value);
  if (!texts) refuse(name, "option '" + option + "' is neither a number, text, true nor an array of numbers or texts");
  return *texts;
}

/// Of the command's own, not where it reads and writes nor what steers recipes.
bool belongs_into_recipe(const CLI::Option& option) {
  const std::vector<std::string>& names = option.get_lnames();
  constexpr std::array<std::string_view, 4> others = {"help", "output", "recipe", "save-recipe"};
  return !names.empty() && std::find(others.begin(), others.end(), names.front()) == others.end();
}

}  // namespace

bool is_recipe(const std::string& name_or_file) {
  const auto& built_in = built_in_recipes();
  if (std::any_of(built_in.begin(), built_in.end(), [&](const auto& r) { return r.name == name_or_file; })) return true;
  std::ifstream file(name_or_file);
  const Json json = Json::parse(file, nullptr, false);
  return json.is_object() && json.contains("format") && json["format"] == format;
}

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
      for (const std::string& text : recipe_values(value, name, key)) option->add_result(text);
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
  for (const std::string& input : recipe_values(recipe["input"], name, "input")) arguments.push_back(input);
  for (const std::string& output : recipe_values(recipe["output"], name, "output"))
    arguments.insert(arguments.end(), {"-o", output});
  for (const auto& [key, value] : recipe["options"].items()) {
    if (value == false) continue;
    for (const std::string& text : recipe_values(value, name, key)) {
      arguments.push_back("--" + key);
      if (value != true) arguments.push_back(text);
    }
  }
  return arguments;
}

}  // namespace isostack::cli
