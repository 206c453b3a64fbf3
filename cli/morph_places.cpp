#include "cli/morph_places.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <string_view>

#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

[[noreturn]] void refuse_path(const std::string& text, Eigen::Index shapes) {
  throw InputError("--path " + text, fmt::format("its corners are not {} weights each", shapes),
                   "give the shapes' weights at every corner, such as \"1,0,0;0,0,1;0,1,0\"");
}

/// Corners between semicolons, weights between commas.
std::vector<Eigen::VectorXd> parse_path(const std::string& text, Eigen::Index shapes) {
  std::vector<Eigen::VectorXd> corners;
  std::string_view rest = text;
  while (!rest.empty()) {
    std::string_view corner = rest.substr(0, rest.find(';'));
    rest.remove_prefix(std::min(rest.size(), corner.size() + 1));
    std::vector<double> weights;
    while (!corner.empty()) {
      const std::string_view number = corner.substr(0, corner.find(','));
      corner.remove_prefix(std::min(corner.size(), number.size() + 1));
      double weight = 0;
      const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), weight);
      if (error != std::errc() || end != number.data() + number.size()) refuse_path(text, shapes);
      weights.push_back(weight);
    }
    if (static_cast<Eigen::Index>(weights.size()) != shapes) refuse_path(text, shapes);
    corners.push_back(Eigen::Map<const Eigen::VectorXd>(weights.data(), shapes));
  }
  return corners;
}

std::string name_of_weights(const Eigen::VectorXd& weights) {
  std::string name;
  for (const double weight : weights) name += fmt::format("{}{:.2f}", name.empty() ? "" : " ", weight + 0.0);
  return name;
}

/// Four digits tell apart a thousand frames.
std::string name_of_time(double t) { return fmt::format("t = {:.4g}", t); }

}  // namespace

void add_place_options(CLI::App& command, PlaceOptions& options) {
  CLI::Option* frames = command.add_option("--frames", options.frames, "Number of frames, both ends included")
                            ->check(CLI::Range(2, 10'000))
                            ->capture_default_str();
  CLI::Option* at = command.add_option("--at", options.at, "Frames at these times only, 0 to 1")
                        ->delimiter(',')
                        ->allow_extra_args(false)
                        ->check(CLI::Range(0.0, 1.0))
                        ->excludes(frames)
                        ->type_name("T1,T2,...");
  CLI::Option* path =
      command
          .add_option("--path", options.path,
                      "Shapes at the corners of a simplex, frames along these weights: \"1,0,0;0,0,1;0,1,0\"")
          ->excludes(at)
          ->type_name("W,W,...;W,W,...");
  command.add_option("--times", options.key_times, "When each shape is reached, ascending (default: evenly)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->excludes(path)
      ->type_name("T1,T2,...");
}

void place_key_shapes(const PlaceOptions& options, std::vector<KeyShape>& shapes) {
  if (options.key_times.empty()) return;
  if (options.key_times.size() != shapes.size())
    throw InputError("--times",
                     fmt::format("there are {} times for {} shapes", options.key_times.size(), shapes.size()),
                     "give one for each");
  for (std::size_t i = 0; i < shapes.size(); ++i) shapes[i].time = options.key_times[i];
}

std::vector<MorphFrame> places_of_frames(const KeyPlaces& places, const PlaceOptions& options) {
  std::vector<MorphFrame> frames;
  const auto count = options.frames;
  if (!options.path.empty()) {
    for (const Eigen::VectorXd& weights :
         weights_along_path(parse_path(options.path, places.key_count()), static_cast<std::size_t>(count))) {
      const double share = static_cast<double>(frames.size()) / (count - 1);
      frames.push_back({.name = name_of_weights(weights), .t = share, .weights = weights, .shape = {}});
    }
    return frames;
  }
  std::vector<double> times = options.at;
  for (int i = 0; options.at.empty() && i < count; ++i) times.push_back(static_cast<double>(i) / (count - 1));
  for (const double t : times)
    frames.push_back({.name = name_of_time(t), .t = t, .weights = places.weights_at(t), .shape = {}});
  return frames;
}

}  // namespace isostack::cli
