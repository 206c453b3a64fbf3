#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace isostack::cli {

// A recipe is a JSON file of a command's options by their long names, as {"format": "isostack-recipe", "version": 1,
// "about": ..., "command": "segment", "input": [...], "output": ..., "options": {"level": 226, ...}}. Flags are true;
// an option of several numbers is an array of numbers; an option that is repeated an array of texts.

struct BuiltInRecipe {
  std::string_view name, text;
};

/// Those of segmentation/recipes and recon/morphing/recipes.
const std::vector<BuiltInRecipe>& built_in_recipes();

/// True for the name of a built-in recipe, or a file that says it is one.
bool is_recipe(const std::string& name_or_file);

/// A built-in recipe by name, or a file. Throws InputError naming it.
nlohmann::ordered_json read_recipe(const std::string& name_or_file);

/// Gives the command every option of the recipe that the command line neither gives nor excludes. Throws InputError
/// naming the recipe and the option that is unknown or has a value that will not do.
void apply_recipe(const nlohmann::ordered_json& recipe, const std::string& name, CLI::App& command);

/// The command as it was given, with the options of any recipe it took, to be run again.
void write_recipe(const CLI::App& command, const std::filesystem::path& path);

/// The recipe as the arguments of a command line, the command first.
std::vector<std::string> arguments_of(const nlohmann::ordered_json& recipe, const std::string& name);

}  // namespace isostack::cli
