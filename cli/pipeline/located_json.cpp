#include "cli/pipeline/located_json.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <vector>

#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

using Json = nlohmann::ordered_json;

/// Characters of the text, counting the lines that were read.
class LineCounter {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  LineCounter(const char* at, int* line) : at_(at), line_(line) {}
  reference operator*() const { return *at_; }
  LineCounter& operator++() {
    if (*at_ == '\n') ++*line_;
    ++at_;
    return *this;
  }
  LineCounter operator++(int) {
    const LineCounter before = *this;
    ++*this;
    return before;
  }
  bool operator==(const LineCounter& other) const { return at_ == other.at_; }
  bool operator!=(const LineCounter& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  int* line_;
};

/// Builds the document and notes the line of every value as the parser comes to it.
class Builder : public nlohmann::json_sax<Json> {
 public:
  Builder(LocatedJson& document, const int& line) : document_(document), line_(line) {}

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(value); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    key_ = name;
    key_line_ = line_;
    if (open_.back().value->contains(name))
      throw InputError(fmt::format("{}, line {}", document_.file.string(), line_),
                       "the key '" + name + "' stands twice", "keep one of them");
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    throw InputError(fmt::format("{}, line {}", document_.file.string(), line_), "it is not valid JSON there",
                     "correct it, or record it anew");
  }

 private:
  struct Open {
    Json* value;
    std::string pointer;
  };

  /// Where the next value goes, its pointer and its line.
  Json* place(Json value, std::string& pointer) {
    if (open_.empty()) {
      document_.value = std::move(value);
      document_.lines[pointer] = line_;
      return &document_.value;
    }
    Json& parent = *open_.back().value;
    pointer = open_.back().pointer + "/" + (parent.is_array() ? std::to_string(parent.size()) : key_);
    document_.lines[pointer] = parent.is_array() ? line_ : key_line_;
    if (!parent.is_array()) return &(parent[key_] = std::move(value));
    parent.push_back(std::move(value));
    return &parent.back();
  }
  bool add(Json value) {
    std::string pointer;
    place(std::move(value), pointer);
    return true;
  }
  bool open(Json value) {
    std::string pointer;
    Json* const at = place(std::move(value), pointer);
    open_.push_back({at, pointer});
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  LocatedJson& document_;
  const int& line_;
  std::string key_;
  int key_line_ = 1;
  std::vector<Open> open_;
};

}  // namespace

std::string LocatedJson::where(const std::string& pointer) const {
  for (std::string at = pointer;; at.resize(at.rfind('/'))) {
    const auto found = lines.find(at);
    if (found != lines.end()) return fmt::format("{}, line {}", file.string(), found->second);
    if (at.find('/') == std::string::npos) return file.string();
  }
}

LocatedJson read_located_json(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file))
    throw InputError(file.string(), "there is no such file", "record one with `--record FILE` on any command");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  LocatedJson document;
  document.file = file;
  int line = 1;
  Builder builder(document, line);
  Json::sax_parse(LineCounter(text.data(), &line), LineCounter(text.data() + text.size(), &line), &builder);
  return document;
}

}  // namespace isostack::cli
