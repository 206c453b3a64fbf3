#include "io/contours/guide_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "io/contours/contour_checks.h"
#include "io/contours/guide_point_files.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/shortest_tour.h"

namespace isostack {

namespace {

/// Points nearer to one another than this, mm, are one.
constexpr double same_place_mm = 1e-3;
/// More points on one slice make no outline that a person traced.
constexpr std::size_t most_points = 5000;

/// The walls that together go round an organ, and the valves where they are open.
struct Organ {
  std::string name;
  std::vector<std::string> walls, valves;
};

const std::vector<Organ>& known_organs() {
  static const std::vector<Organ> organs = {
      {"LV endocardium", {"LV_ENDOCARDIAL"}, {"MITRAL_VALVE", "AORTA_VALVE"}},
      {"RV endocardium", {"RV_SEPTUM", "RV_FREEWALL"}, {"TRICUSPID_VALVE", "PULMONARY_VALVE"}},
      {"epicardium",
       {"LV_EPICARDIAL", "RV_EPICARDIAL"},
       {"MITRAL_VALVE", "AORTA_VALVE", "TRICUSPID_VALVE", "PULMONARY_VALVE"}}};
  return organs;
}

using SliceSets = std::map<std::string, GuidePointSet>;

bool is_view(const std::string& name) { return name.starts_with("SAX_") || name.starts_with("LAX_"); }

const GuidePointSet* wall_on(const SliceSets& sets, const std::string& wall) {
  for (const char* view : {"SAX_", "LAX_"})
    if (const auto found = sets.find(view + wall); found != sets.end()) return &found->second;
  return nullptr;
}

/// Where the slice shows the right ventricle, the epicardium needs both of its parts to go round.
bool is_whole(const Organ& organ, const SliceSets& sets) {
  if (organ.name != "epicardium") return true;
  const bool shows_right = wall_on(sets, "RV_EPICARDIAL") || wall_on(sets, "RV_SEPTUM") || wall_on(sets, "RV_FREEWALL");
  return wall_on(sets, "LV_EPICARDIAL") && (!shows_right || wall_on(sets, "RV_EPICARDIAL"));
}

void add_points(const GuidePointSet& set, const SlicePose& pose, const std::string& where,
                std::vector<Eigen::Vector2d>& points) {
  for (const Eigen::Vector3d& point : set.points_mm) {
    const double off_mm = std::abs(pose.signed_distance_mm(point));
    if (off_mm > pose.spacing_mm.maxCoeff())
      throw InputError(where, fmt::format("a point lies {:.1f} mm off the plane of its slice", off_mm),
                       "use the SliceInfoFile.txt that belongs to it");
    const Eigen::Vector2d place = pose.world_to_slice(point);
    const bool is_new = std::none_of(points.begin(), points.end(),
                                     [&](const auto& other) { return (other - place).norm() < same_place_mm; });
    if (is_new) points.push_back(place);
  }
}

std::vector<Eigen::Vector2d> points_of(const Organ& organ, const SliceSets& sets, const SlicePose& pose,
                                       const std::string& where) {
  std::size_t count = 0;
  for (const auto& [name, set] : sets) count += set.points_mm.size();
  if (count > most_points)
    throw InputError(where, fmt::format("it has {} points", count), "thin the outlines to some hundred points each");
  std::vector<Eigen::Vector2d> points;
  for (const std::string& wall : organ.walls)
    if (const GuidePointSet* set = wall_on(sets, wall)) add_points(*set, pose, where, points);
  if (points.empty()) return points;
  for (const std::string& valve : organ.valves)
    if (const auto found = sets.find(valve); found != sets.end()) add_points(found->second, pose, where, points);
  return points;
}

std::string slice_name(int number, const SliceSets& sets) {
  const bool is_long =
      std::any_of(sets.begin(), sets.end(), [](const auto& set) { return set.first.starts_with("LAX_"); });
  return fmt::format("{} axis {}", is_long ? "long" : "short", number);
}

/// Reads one organ after the other from the same table.
class Loops {
 public:
  Loops(const std::filesystem::path& path)
      : file_(path.string()),
        points_(read_guide_point_table(path)),
        poses_(read_slice_poses(slice_info_beside(path))) {}

  const GuidePoints& points() const { return points_; }

  void add(const Organ& organ, ContourFile& result) const {
    ContourStack stack{.name = organ.name, .slices = {}};
    for (const auto& [number, sets] : points_) {
      ContourSlice slice{.name = slice_name(number, sets), .pose = pose_of(number), .contours = {}};
      const std::string where = contour_place(file_, slice.name);
      std::vector<Eigen::Vector2d> loop = points_of(organ, sets, slice.pose, where);
      if (loop.empty()) continue;
      if (loop.size() < 3 || !is_whole(organ, sets)) {
        result.warnings.push_back(fmt::format(
            "{}, {}: {}, so it was left out there", organ.name, slice.name,
            loop.size() < 3 ? fmt::format("{} points make no outline", loop.size()) : "traced on one ventricle only"));
        continue;
      }
      slice.contours.push_back({.points_mm = shortest_tour(std::move(loop))});
      complete_slice(slice, file_);
      stack.slices.push_back(std::move(slice));
    }
    if (!stack.slices.empty()) result.organs.push_back(std::move(stack));
  }

 private:
  const SlicePose& pose_of(int slice) const {
    const auto found = poses_.find(slice);
    if (found == poses_.end())
      throw InputError(file_, fmt::format("the pose of slice {} is missing", slice), "add it to SliceInfoFile.txt");
    return found->second;
  }

  std::string file_;
  GuidePoints points_;
  std::map<int, SlicePose> poses_;
};

/// Traced surfaces that belong to no known organ, each an organ of its own.
std::vector<Organ> further_organs(const GuidePoints& points) {
  std::vector<Organ> organs;
  for (const auto& [number, sets] : points)
    for (const auto& [name, set] : sets) {
      if (!is_view(name)) continue;
      const std::string wall = name.substr(4);
      const auto has_wall = [&](const Organ& organ) {
        return std::count(organ.walls.begin(), organ.walls.end(), wall) > 0;
      };
      const auto is_in = [&](const std::vector<Organ>& list) {
        return std::any_of(list.begin(), list.end(), has_wall);
      };
      if (!is_in(known_organs()) && !is_in(organs)) organs.push_back({wall, {wall}, {}});
    }
  return organs;
}

}  // namespace

bool holds_guide_points(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string start(200, '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  return is_guide_point_header(start.substr(0, start.find('\n')));
}

ContourFile read_guide_points(const std::filesystem::path& path, const ReadOptions& /*options*/) {
  const Loops loops(path);
  ContourFile result;
  for (const Organ& organ : known_organs()) loops.add(organ, result);
  for (const Organ& organ : further_organs(loops.points())) loops.add(organ, result);
  if (result.organs.empty())
    throw InputError(path.string(), "no surface in it has an outline",
                     "it needs points of SAX_ or LAX_ surfaces, three or more per slice");
  return result;
}

}  // namespace isostack
