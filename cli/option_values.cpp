#include "cli/option_values.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>

namespace isostack::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

}  // namespace

bool is_flag(const CLI::Option& option) { return option.get_expected_max() == 0; }

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

std::optional<std::vector<std::string>> argument_values(const Json& value) {
  if (value.is_string() || value.is_number() || value.is_boolean()) return std::vector{text_of(value)};
  if (!value.is_array()) return std::nullopt;
  std::vector<std::string> texts;
  for (const Json& item : value) {
    if (!item.is_string() && !item.is_number()) return std::nullopt;
    texts.push_back(text_of(item));
  }
  const bool all_numbers = std::all_of(value.begin(), value.end(), [](const Json& item) { return item.is_number(); });
  if (!all_numbers || texts.size() < 2) return texts;
  std::string joined;
  for (const std::string& text : texts) joined += (joined.empty() ? "" : ",") + text;
  return std::vector{joined};
}

}  // namespace isostack::cli
