#include "cli/morph_outputs.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/outputs.h"
#include "io/atomic_folder.h"
#include "io/contours/contour_files.h"
#include "io/formats.h"
#include "io/images/write_pictures.h"
#include "io/meshes/write_mesh.h"
#include "recon/geometry/errors.h"
#include "recon/morphing/spacetime_surface.h"
#include "viewers/contact_sheet.h"

namespace isostack::cli {

namespace {

namespace fs = std::filesystem;

enum class OutputKind { animation, contact_sheet, contours, mesh, folder };

const std::string frame_prefix = "frame_";

/// `.vtp` holds contours or a mesh: of figures it is contours.
OutputKind kind_of(const fs::path& path, bool figures) {
  const std::string extension = path.extension().string();
  if (extension == ".gif") return OutputKind::animation;
  if (extension == ".png") return OutputKind::contact_sheet;
  if (extension == ".json" || (extension == ".vtp" && figures)) return OutputKind::contours;
  if (find_format(path, &Format::write_mesh)) return OutputKind::mesh;
  if (extension.empty() || fs::is_directory(path)) return OutputKind::folder;
  std::vector<std::string_view> extensions = {".gif", ".png", ".json"};
  for (const std::string_view mesh : extensions_with(&Format::write_mesh)) extensions.push_back(mesh);
  throw_unknown_extension(path, "a morph (a folder of frames has none)", extensions);
}

void write_frame(const MorphFrame& frame, const fs::path& path) {
  if (!frame.is_figure()) return write_mesh(frame.body(), path);
  write_contours({{.name = frame.name, .slices = {frame.figure()}}}, path);
}

/// frame_000 and so on.
void write_folder(const std::vector<MorphFrame>& frames, const std::vector<Picture>& pictures,
                  const std::string& format, const fs::path& path) {
  AtomicFolder folder(path, frame_prefix);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const fs::path file = folder.temporary() / fmt::format("{}{:03}.{}", frame_prefix, i, format);
    if (format == "png")
      write_png(pictures[i], file);
    else
      write_frame(frames[i], file);
  }
  folder.commit();
}

void write_sheet(const std::vector<MorphFrame>& frames, const std::vector<Picture>& pictures, const fs::path& path) {
  std::vector<CaptionedPicture> captioned;
  for (std::size_t i = 0; i < frames.size(); ++i) captioned.push_back({pictures[i], frames[i].name});
  write_png(contact_sheet(captioned), path);
}

std::vector<fs::path> write_bodies(const std::vector<MorphFrame>& frames, const fs::path& path) {
  std::vector<fs::path> written;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    written.push_back(frames.size() == 1 ? path : with_suffix(path, fmt::format("{:03}", i)));
    write_mesh(frames[i].body(), written.back());
  }
  return written;
}

/// What the files of a folder are.
std::string folder_format(const MorphOutputs& outputs, bool figures) {
  return outputs.format.empty() ? (figures ? "png" : "stl") : outputs.format;
}

bool needs_pictures(const fs::path& path, const MorphOutputs& outputs, bool figures) {
  const OutputKind kind = kind_of(path, figures);
  return kind == OutputKind::animation || kind == OutputKind::contact_sheet ||
         (kind == OutputKind::folder && folder_format(outputs, figures) == "png");
}

TriangleMesh swept_surface(const std::vector<MorphFrame>& frames, const Morph& morph, const Progress& progress) {
  if (auto mesh = spacetime_surface(morph, frames.front().figure().pose, progress)) return *std::move(mesh);
  throw InputError("-o", "a level-set morph, or shapes that do not lie on a line, have no surface in space-time",
                   "take another method, leave out --path, or write contours (.json, .vtp)");
}

ContourStack swept_slices(const std::vector<MorphFrame>& frames, const Morph& morph) {
  std::vector<ContourSlice> figures;
  std::vector<Eigen::VectorXd> weights;
  for (const MorphFrame& frame : frames) {
    figures.push_back(frame.figure());
    figures.back().name = frame.name;
    weights.push_back(frame.weights);
  }
  return spacetime_slices(morph, figures, weights);
}

}  // namespace

void require_writable(const MorphOutputs& outputs) {
  for (const fs::path& path : outputs.paths) {
    if (kind_of(path, true) == OutputKind::folder) {
      AtomicFolder::require_replaceable(path, frame_prefix);
      continue;
    }
    const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
    if (!fs::is_directory(folder))
      throw InputError(path.string(), "its folder does not exist", "create " + folder.string());
  }
}

void require_fitting(const MorphOutputs& outputs, int dimension) {
  const bool figures = dimension == 2;
  for (const fs::path& path : outputs.paths) {
    const OutputKind kind = kind_of(path, figures);
    if (kind == OutputKind::contours && !figures)
      throw InputError(path.string(), "the frames are bodies and have no contours",
                       "write meshes (.stl, .ply, .obj, .vtp) or a folder");
    if (kind != OutputKind::folder) continue;
    const std::string format = folder_format(outputs, figures);
    const bool fits = format == "png" || (figures ? format == "json" || format == "vtp" : format != "json");
    if (!fits)
      throw InputError("--format " + format, figures ? "the frames are figures" : "the frames are bodies",
                       figures ? "use png, json or vtp" : "use png, stl, ply, obj, vtp or glb");
  }
}

MorphProducts products_for(const std::vector<MorphFrame>& frames, const Morph& morph, const MorphOutputs& outputs,
                           const Progress& progress) {
  const bool figures = frames.front().is_figure();
  const auto any = [&](const auto& needs) { return std::any_of(outputs.paths.begin(), outputs.paths.end(), needs); };
  MorphProducts products;
  if (any([&](const fs::path& path) { return needs_pictures(path, outputs, figures); }))
    products.pictures = pictures_of(frames, outputs.pictures, progress);
  if (figures && any([](const fs::path& path) { return kind_of(path, true) == OutputKind::mesh; }))
    products.spacetime = swept_surface(frames, morph, progress);
  if (figures) products.slices = swept_slices(frames, morph);
  progress.report("write", 0);
  return products;
}

void write_outputs(const std::vector<MorphFrame>& frames, const MorphProducts& products, const MorphOutputs& outputs,
                   Session& session) {
  const bool figures = frames.front().is_figure();
  for (const fs::path& path : outputs.paths) {
    std::vector<fs::path> written = {path};
    switch (kind_of(path, figures)) {
      case OutputKind::animation:
        write_gif(products.pictures, path, {.frames_per_second = outputs.frames_per_second});
        break;
      case OutputKind::contact_sheet:
        write_sheet(frames, products.pictures, path);
        break;
      case OutputKind::contours:
        write_contours({products.slices}, path);
        break;
      case OutputKind::mesh:
        if (figures)
          write_mesh(products.spacetime, path);
        else
          written = write_bodies(frames, path);
        break;
      case OutputKind::folder:
        write_folder(frames, products.pictures, folder_format(outputs, figures), path);
        break;
    }
    for (const fs::path& file : written) {
      session.wrote(file);
    }
  }
}

}  // namespace isostack::cli
