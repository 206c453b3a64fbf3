#include "cli/manual_page.h"

#include <CLI/CLI.hpp>

namespace isostack::cli {

namespace {

/// Text as roff shows it: backslashes and dashes as they are, no line taken for a request.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') result += "\\e";
    if (c == '-') result += "\\-";
    if (c != '\\' && c != '-') result += c;
    if (c == '\n') result += "\\&";
  }
  return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string option_head(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : option.get_snames()) names += (names.empty() ? "" : ", ") + ("\\-" + escaped(name));
  for (const std::string& name : option.get_lnames()) names += (names.empty() ? "" : ", ") + ("\\-\\-" + escaped(name));
  if (names.empty()) names = escaped(option.get_name(true, false));
  std::string head = "\\fB" + names + "\\fR";
  const std::string type = option.get_type_name();
  if (option.get_expected_max() > 0 && !option.get_positional() && !type.empty())
    head += " \\fI" + escaped(type) + "\\fR";
  return head;
}

std::string option_text(const CLI::Option& option) {
  std::string text = ".TP\n" + option_head(option) + "\n" + escaped(option.get_description());
  if (!option.get_default_str().empty()) text += " (default: " + escaped(option.get_default_str()) + ")";
  return text + "\n";
}

std::string options_text(const CLI::App& app) {
  std::string text;
  for (const bool positional : {true, false})
    for (const CLI::Option* option : app.get_options())
      if (option->get_positional() == positional) text += option_text(*option);
  return text;
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string page = ".TH ISOSTACK 1 \"\" \"isostack " ISOSTACK_VERSION
                     "\" \"User Commands\"\n.SH NAME\n"
                     "isostack \\- from stacks of medical image slices to one smooth closed surface per organ\n"
                     ".SH SYNOPSIS\n.B isostack\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR] [\\fIARGUMENTS\\fR]\n"
                     ".SH DESCRIPTION\n" +
                     escaped(app.get_description()) + "\n.SH COMMON OPTIONS\n" + options_text(app);
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    page += ".SH \"COMMAND " + escaped(command->get_name()) + "\"\n" + escaped(command->get_description()) + "\n" +
            options_text(*command);
  return page +
         ".SH EXIT STATUS\n.TP\n0\ndone\n.TP\n2\nwrong usage\n.TP\n3\nbad input or surroundings\n"
         ".TP\n4\ncould not solve within tolerance or memory\n.TP\n5\ncancelled\n";
}

}  // namespace isostack::cli
