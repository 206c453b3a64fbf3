#include "cli/completions.h"

#include <CLI/CLI.hpp>

#include "cli/option_values.h"
#include "cli/path_roles.h"

namespace isostack::cli {

namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// The words of "TEXT:{a,b}", the help's way to show a fixed set; empty for any other type.
std::string choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t open = type.find('{'), close = type.find('}', open == std::string::npos ? 0 : open);
  if (open == std::string::npos || close == std::string::npos) return "";
  std::string words = type.substr(open + 1, close - open - 1);
  for (char& c : words)
    if (c == ',') c = ' ';
  return words;
}

bool takes_path(const CLI::Option& option) {
  return path_role(option).has_value() || option.get_type_name().find("FILE") != std::string::npos;
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::string joined(const std::vector<std::string>& words, const char* separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

std::string all_names(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : names_of(*option)) words.push_back(name);
  return joined(words, " ");
}

/// The case of an option's value, in the command's case of a bash script.
std::string bash_values(const CLI::Option& option) {
  if (is_flag(option) || names_of(option).empty()) return "";
  const std::string choices = choices_of(option);
  const std::string action = !choices.empty() ? "COMPREPLY=($(compgen -W '" + choices + "' -- \"$current\"))"
                             : takes_path(option)
                                 ? std::string("compopt -o filenames; COMPREPLY=($(compgen -f -- \"$current\"))")
                                 : std::string("COMPREPLY=()");
  return "        " + joined(names_of(option), "|") + ") " + action + "; return ;;\n";
}

/// Text between single quotes, in brackets.
std::string zsh_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') result += "'\\'";
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

std::string zsh_argument(const CLI::Option& option) {
  const std::string choices = choices_of(option);
  const std::string action = !choices.empty() ? "(" + choices + ")" : takes_path(option) ? std::string("_files") : " ";
  if (names_of(option).empty()) return "          '*:" + zsh_text(option.get_name(true, false)) + ":_files'";
  std::string arguments;
  for (const std::string& name : names_of(option))
    arguments += (arguments.empty() ? "" : " \\\n") +
                 ("          '*" + name + "[" + zsh_text(option.get_description()) + "]") +
                 (is_flag(option) ? "'" : ":value:" + action + "'");
  return arguments;
}

std::string zsh_arguments(const CLI::App& app) {
  std::string text;
  for (const CLI::Option* option : app.get_options()) text += " \\\n" + zsh_argument(*option);
  return text;
}

}  // namespace

std::string bash_completions(const CLI::App& app) {
  std::vector<std::string> names;
  std::string cases;
  for (const CLI::App* command : commands_of(app)) {
    names.push_back(command->get_name());
    cases += "    " + command->get_name() + ")\n      case \"$previous\" in\n";
    for (const CLI::Option* option : command->get_options()) cases += bash_values(*option);
    for (const CLI::Option* option : app.get_options()) cases += bash_values(*option);
    cases += "      esac\n      options='" + all_names(*command) + " " + all_names(app) + "' ;;\n";
  }
  return "# bash completion for isostack\n"
         "_isostack() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command='' options='' word\n"
         "  COMPREPLY=()\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    case $word in " +
         joined(names, "|") +
         ") command=$word; break ;; esac\n"
         "  done\n"
         "  case $command in\n" +
         cases + "    *) options='" + joined(names, " ") + " " + all_names(app) +
         "' ;;\n"
         "  esac\n"
         "  if [[ -z $command || $current == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$options\" -- \"$current\"))\n"
         "  else\n"
         "    compopt -o filenames; COMPREPLY=($(compgen -f -- \"$current\"))\n"
         "  fi\n"
         "}\n"
         "complete -F _isostack isostack\n";
}

std::string zsh_completions(const CLI::App& app) {
  std::string list, cases;
  for (const CLI::App* command : commands_of(app)) {
    list += "    '" + command->get_name() + ":" + zsh_text(command->get_description()) + "'\n";
    cases += "        " + command->get_name() + ")\n          _arguments -s" + zsh_arguments(*command) +
             zsh_arguments(app) + " ;;\n";
  }
  return "#compdef isostack\n"
         "_isostack() {\n"
         "  local state line\n"
         "  local -a commands\n"
         "  commands=(\n" +
         list +
         "  )\n"
         "  _arguments -C" +
         zsh_arguments(app) +
         " \\\n"
         "          '1:command:->command' '*::argument:->argument'\n"
         "  case $state in\n"
         "    command) _describe command commands ;;\n"
         "    argument)\n"
         "      case $line[1] in\n" +
         cases +
         "      esac ;;\n"
         "  esac\n"
         "}\n"
         "_isostack \"$@\"\n";
}

}  // namespace isostack::cli
