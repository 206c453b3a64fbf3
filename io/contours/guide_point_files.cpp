#include "io/contours/guide_point_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <sstream>

#include "io/file_listing.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

std::string place(const std::filesystem::path& path, int line) {
  return fmt::format("{}, line {}", path.string(), line);
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

template <class Number>
std::optional<Number> number_in(const std::string& word) {
  Number value{};
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || rest != end) return std::nullopt;
  return value;
}

/// `count` finite numbers of the words from `first` on.
std::vector<double> numbers_at(const std::vector<std::string>& words, std::size_t first, std::size_t count,
                               const std::string& where) {
  std::vector<double> numbers;
  for (std::size_t i = first; i < first + count; ++i) {
    const auto number = i < words.size() ? number_in<double>(words[i]) : std::nullopt;
    if (!number || !std::isfinite(*number))
      throw InputError(where,
                       i < words.size() ? "'" + words[i].substr(0, 40) + "' is not a number" : "the line is cut off",
                       "repair the line");
    numbers.push_back(*number);
  }
  return numbers;
}

int slice_number(const std::vector<std::string>& words, std::size_t index, const std::string& where) {
  const auto number = index < words.size() ? number_in<int>(words[index]) : std::nullopt;
  if (!number) throw InputError(where, "the number of the slice is missing", "repair the line");
  return *number;
}

void add_point(const std::vector<std::string>& words, const std::string& where, GuidePoints& points) {
  const std::vector<double> position = numbers_at(words, 0, 3, where);
  const int slice = slice_number(words, 4, where);
  GuidePointSet& set = points[slice][words[3]];
  const std::string time_frame = words.size() > 6 ? words[6] : "";
  if (!set.points_mm.empty() && set.time_frame != time_frame)
    throw InputError(where,
                     fmt::format("{} of slice {} has points of several time frames", words[3].substr(0, 40), slice),
                     "give each time frame a file of its own");
  set.time_frame = time_frame;
  set.points_mm.emplace_back(position[0], position[1], position[2]);
}

SlicePose pose_in(const std::vector<std::string>& words, const std::string& where) {
  const auto behind = [&](const char* key) {
    const auto found = std::find(words.begin(), words.end(), key);
    if (found == words.end()) throw InputError(where, fmt::format("{} is missing", key), "repair the line");
    return static_cast<std::size_t>(found - words.begin()) + 1;
  };
  const std::vector<double> origin = numbers_at(words, behind("ImagePositionPatient"), 3, where);
  const std::vector<double> axes = numbers_at(words, behind("ImageOrientationPatient"), 6, where);
  const std::vector<double> spacing = numbers_at(words, behind("PixelSpacing"), 2, where);
  SlicePose pose;
  pose.origin_mm = Eigen::Vector3d::Map(origin.data());
  pose.x_axis = Eigen::Vector3d::Map(axes.data());
  pose.y_axis = Eigen::Vector3d::Map(axes.data() + 3);
  pose.spacing_mm = {spacing[1], spacing[0]};  // DICOM: rows first
  return checked_pose(pose, where);
}

}  // namespace

bool is_guide_point_header(const std::string& line) {
  const std::vector<std::string> words = words_of(line);
  const std::vector<std::string> expected = {"x", "y", "z", "contour", "type"};
  return words.size() >= expected.size() && std::equal(expected.begin(), expected.end(), words.begin());
}

GuidePoints read_guide_point_table(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string line;
  if (!std::getline(stream, line) || !is_guide_point_header(line.substr(0, 200)))
    throw InputError(path.string(), "it is not a table of guide points",
                     "its first line must name the columns x, y, z, contour type, frameID, weight, time frame");
  GuidePoints points;
  for (int number = 2; std::getline(stream, line); ++number) {
    const std::vector<std::string> words = words_of(line);
    if (!words.empty()) add_point(words, place(path, number), points);
  }
  if (points.empty()) throw InputError(path.string(), "it holds no guide point", "it is empty or truncated");
  return points;
}

std::map<int, SlicePose> read_slice_poses(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::map<int, SlicePose> poses;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const std::vector<std::string> words = words_of(line);
    if (words.empty()) continue;
    const std::string where = place(path, number);
    const auto key = std::find(words.begin(), words.end(), "sliceID:");
    const int slice = slice_number(words, static_cast<std::size_t>(key - words.begin()) + 1, where);
    if (!poses.emplace(slice, pose_in(words, where)).second)
      throw InputError(where, fmt::format("slice {} occurs twice", slice), "repair the file");
  }
  if (poses.empty()) throw InputError(path.string(), "it holds no slice", "it is empty or truncated");
  return poses;
}

std::filesystem::path slice_info_beside(const std::filesystem::path& guide_points) {
  const std::filesystem::path folder = guide_points.has_parent_path() ? guide_points.parent_path() : ".";
  if (std::filesystem::is_regular_file(folder / "SliceInfoFile.txt")) return folder / "SliceInfoFile.txt";
  std::vector<std::filesystem::path> found;
  for (const std::filesystem::path& file : files_in(folder, Depth::kThisFolder)) {
    const std::string name = file.filename().string();
    if (name.starts_with("SliceInfo") && name.ends_with(".txt")) found.push_back(file);
  }
  if (found.size() == 1) return found.front();
  throw InputError(
      guide_points.string(),
      found.empty() ? "the poses of its slices are missing" : "there are several files SliceInfo*.txt beside it",
      "put its SliceInfoFile.txt into the same folder");
}

}  // namespace isostack
