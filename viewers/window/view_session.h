#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viewers/grey_window.h"
#include "viewers/window/contour_edit.h"

namespace isostack {

enum class WindowLayout { both, scene, slice };        ///< what the window is divided into
enum class PointerMode { pick, measure, edit, seed };  ///< what a click does
enum class ClipSide { none, front, back };             ///< which side of the shown plane surfaces are hidden on
enum class ImagesShown { shown_plane, all, none };     ///< which slices the 3D scene has

struct ViewLayers {
  bool surfaces = true, contours = true, cut_lines = true, marks = true;
  ImagesShown images = ImagesShown::shown_plane;
};

/// Parallel projection; world LPS mm.
struct ViewCamera {
  Eigen::Vector3d position_mm = {0, -1, 0}, focal_mm = Eigen::Vector3d::Zero(), up = {0, 0, 1};
  double height_mm = 1;  ///< of what fits into the view
};

struct Measurement {
  Eigen::Vector3d from_mm = Eigen::Vector3d::Zero(), to_mm = Eigen::Vector3d::Zero();

  double length_mm() const { return (to_mm - from_mm).norm(); }
};

/// The name of seeds on what is not wanted.
inline constexpr const char* unwanted_seed = "-";

struct ViewSeed {
  Eigen::Vector3d position_mm = Eigen::Vector3d::Zero();
  std::string name = "organ";  ///< of the organ, or unwanted_seed
};

/// All that a window shows beyond what its files hold, world LPS mm.
struct ViewState {
  std::size_t plane = 0;  ///< in the order of view_planes()
  WindowLayout layout = WindowLayout::both;
  PointerMode pointer = PointerMode::pick;
  ViewLayers layers = {};
  ClipSide clip = ClipSide::none;
  bool side_by_side = false;
  double surface_opacity = 1;
  double reach_mm = 5;                              ///< of the neighbours that follow a moved point
  std::size_t frame = 0;                            ///< of the morph
  std::optional<GreyWindow> grey = std::nullopt;    ///< none: automatic
  std::optional<ViewCamera> camera = std::nullopt;  ///< none: oblique, at all that is shown
  std::vector<Eigen::Vector3d> picks_mm = {};
  std::vector<Measurement> measurements = {};
  std::vector<ViewSeed> seeds = {};
  bool is_segmented = false;  ///< the contours are those of the seeds, not of the files
  std::vector<EditStep> edits = {};
  bool is_solved = false;  ///< the surfaces go through the contours as segmented and edited: they are solved anew
};

/// What `isostack view` needs to open the same window again.
struct ViewSession {
  std::vector<std::filesystem::path> inputs = {};  ///< absolute, or relative to the working folder
  std::vector<std::filesystem::path> frames = {};  ///< surfaces of a morph, in order
  std::vector<std::filesystem::path> beside = {};  ///< surfaces of a second result
  std::string title = {};
  bool dark = false;
  ViewState state = {};
};

/// True for a file that holds a session, whatever else it may be.
bool is_view_session(const std::filesystem::path& path);

/// The schema is docs/schemas/view-session.schema.json; paths in the file are relative to its folder. Throws InputError
/// naming the file and what is wrong in it.
ViewSession read_view_session(const std::filesystem::path& path);

/// The file appears whole or not at all. Throws InputError when it cannot be written.
void write_view_session(const ViewSession& session, const std::filesystem::path& path);

}  // namespace isostack
