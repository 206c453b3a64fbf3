#include "io/contours/text_tokens.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr std::string_view space = " \t\r\n\f\v";

/// What a message may show of the file.
std::string shown(std::string_view word) {
  std::string text(word.substr(0, 40));
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return text;
}

}  // namespace

TextTokens::TextTokens(const std::filesystem::path& path) : file_(path.string()) {
  std::ifstream stream(path, std::ios::binary);
  text_.assign(std::istreambuf_iterator<char>(stream), {});
}

void TextTokens::skip_space() {
  for (; at_ < text_.size(); ++at_) {
    if (text_[at_] == '#') at_ = std::min(text_.find('\n', at_), text_.size());
    if (at_ == text_.size()) return;
    if (text_[at_] == '\n')
      ++line_;
    else if (space.find(text_[at_]) == std::string_view::npos)
      return;
  }
}

bool TextTokens::at_end() {
  skip_space();
  return at_ >= text_.size();
}

std::string_view TextTokens::word(std::string_view what) {
  if (at_end()) fail(fmt::format("the file ends where {} is missing", what));
  const std::size_t end = std::min(text_.find_first_of(space, at_), text_.size());
  const std::string_view result = std::string_view(text_).substr(at_, end - at_);
  at_ = end;
  return result;
}

double TextTokens::number(std::string_view what) {
  std::string_view text = word(what);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size() || !std::isfinite(value))
    fail(fmt::format("'{}' is no number for {}", shown(text), what));
  return value;
}

long long TextTokens::whole_number(std::string_view what) {
  const std::string_view text = word(what);
  long long value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size())
    fail(fmt::format("'{}' is no whole number for {}", shown(text), what));
  return value;
}

std::size_t TextTokens::count(std::string_view what, std::size_t bytes_each) {
  const long long value = whole_number(what);
  const std::size_t left = text_.size() - at_;
  if (value < 0 || static_cast<std::size_t>(value) > left / bytes_each)
    fail(fmt::format("{} is {}, which does not fit into the rest of the file", what, value));
  return static_cast<std::size_t>(value);
}

std::string TextTokens::where() const { return fmt::format("{}, line {}", file_, line_); }

void TextTokens::fail(const std::string& problem) const {
  throw InputError(where(), problem, "the file is truncated, damaged or another format");
}

}  // namespace isostack
