#include "cli/options_page.h"

#include <CLI/CLI.hpp>
#include <set>

namespace isostack::cli {

namespace {

/// Text in a cell of a table.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '*' || c == '_') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

/// Between backquotes, where a table's bar must still be escaped.
std::string code(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return text.empty() ? "" : "`" + result + "`";
}

std::string names_of(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : option.get_snames()) names += (names.empty() ? "" : ", ") + code("-" + name);
  for (const std::string& name : option.get_lnames()) names += (names.empty() ? "" : ", ") + code("--" + name);
  return names.empty() ? code(option.get_name(true, false)) : names;
}

/// "TEXT:{a,b}" as the words, anything else as the help shows it.
std::string values_of(const CLI::Option& option) {
  if (option.get_expected_max() == 0) return "";
  std::string type = option.get_type_name();
  if (const std::size_t open = type.find('{'); open != std::string::npos)
    type = type.substr(open + 1, type.find('}') - open - 1);
  std::string words;
  for (const std::string& word : CLI::detail::split(type, ',')) words += (words.empty() ? "" : ", ") + word;
  const bool is_choice = option.get_type_name().find('{') != std::string::npos;
  return code(is_choice ? words : option.get_type_name());
}

std::string list_of(const std::set<CLI::Option*>& options, const char* before) {
  std::string text;
  for (const CLI::Option* option : options) text += (text.empty() ? before : std::string(", ")) + names_of(*option);
  return text.empty() ? "" : text + ".";
}

std::string row_of(const CLI::Option& option) {
  std::string meaning = cell(option.get_description());
  if (option.get_required()) meaning += ". Required.";
  const std::string more = list_of(option.get_needs(), " Needs ") + list_of(option.get_excludes(), " Not with ");
  if (!more.empty()) meaning += (option.get_required() ? "" : ".") + more;
  return "| " + names_of(option) + " | " + values_of(option) + " | " + code(option.get_default_str()) + " | " +
         meaning + " |\n";
}

std::string table_of(const CLI::App& app) {
  std::string text = "| option | value | default | meaning |\n| --- | --- | --- | --- |\n";
  for (const bool positional : {true, false})
    for (const CLI::Option* option : app.get_options())
      if (option->get_positional() == positional) text += row_of(*option);
  return text;
}

}  // namespace

std::string options_page(const CLI::App& app) {
  std::string page =
      "# Every option\n\nOf isostack " ISOSTACK_VERSION
      ", from the program itself (`isostack --generate markdown`). What they do together is in "
      "[Commands](commands.md). "
      "A default that is not shown is told in the meaning, or follows from the input.\n\n## All commands\n\n" +
      table_of(app);
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    page += "\n## " + command->get_name() + "\n\n" + cell(command->get_description()) + ".\n\n" + table_of(*command);
  return page;
}

}  // namespace isostack::cli
