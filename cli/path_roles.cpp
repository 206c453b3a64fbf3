#include "cli/path_roles.h"

#include <CLI/CLI.hpp>

namespace isostack::cli {

namespace {

constexpr const char* read_mark = "path that is read";
constexpr const char* written_mark = "path that is written";

/// CLI11 options carry no data of ours but named validators: one that accepts everything and says nothing.
CLI::Validator mark(const char* name) {
  return {[](std::string&) { return std::string(); }, "", name};
}

bool has_mark(const CLI::Option& option, const char* name) {
  try {
    return const_cast<CLI::Option&>(option).get_validator(name) != nullptr;
  } catch (const CLI::OptionNotFound&) {
    return false;
  }
}

}  // namespace

CLI::Validator read_path() { return mark(read_mark); }

CLI::Validator written_path() { return mark(written_mark); }

std::optional<PathRole> path_role(const CLI::Option& option) {
  if (has_mark(option, read_mark)) return PathRole::kRead;
  if (has_mark(option, written_mark)) return PathRole::kWritten;
  return std::nullopt;
}

std::string option_key(const CLI::Option& option) {
  return option.get_lnames().empty() ? option.get_name(true, false) : option.get_lnames().front();
}

}  // namespace isostack::cli
