#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "cli/convert_bodies.h"
#include "cli/convert_inputs.h"
#include "cli/input_options.h"
#include "cli/label_inputs.h"
#include "cli/label_outputs.h"
#include "cli/like_options.h"
#include "cli/outputs.h"
#include "cli/path_roles.h"
#include "cli/retriangulation.h"
#include "io/contours/contour_files.h"
#include "io/dicom/series_planes.h"
#include "io/formats.h"
#include "io/meshes/read_mesh.h"
#include "io/meshes/write_mesh.h"
#include "io/volumes/volume_files.h"
#include "recon/geometry/errors.h"
#include "recon/surface/plane_section.h"

namespace isostack::cli {

namespace {

struct ConvertCommand {
  InputOptions input;
  std::filesystem::path output;
  LikeOptions like;
  BodyConversion bodies;
  RetriangulationOptions retriangulation;  ///< of meshes
  std::string axes = "lps", input_axes = "lps";

  const std::filesystem::path& path() const { return input.paths.front(); }
};

[[noreturn]] void throw_other_kind(const ConvertCommand& command, const std::string& kind, const std::string& remedy) {
  throw InputError(command.output.string(), "it cannot hold " + kind + ", which " + command.path().string() + " is",
                   remedy);
}

WriteOptions write_options(const ConvertCommand& command) {
  WriteOptions options = write_options_for(command.like, command.input);
  options.axes = command.axes == "ras" ? MeshAxes::ras : MeshAxes::lps;
  return options;
}

std::vector<ContourStack> organs_of(const ConvertCommand& command, Session& session) {
  if (!command.input.organs.empty()) return organs_from(command.input, session);
  ContourFile file = read_contour_file(command.path(), command.input.read_options());
  for (const std::string& warning : file.warnings) session.note(warning);
  return std::move(file.organs);
}

/// For formats that say of every plane which organs are there.
void note_planes_left_open(const std::vector<ContourStack>& organs, Session& session) {
  constexpr double same_plane_mm = 1e-3;
  std::vector<SlicePose> planes;
  const auto is_known = [&](const SlicePose& pose) {
    return std::any_of(planes.begin(), planes.end(),
                       [&](const auto& p) { return in_one_plane(p, pose, same_plane_mm); });
  };
  for (const ContourStack& organ : organs)
    for (const ContourSlice& slice : organ.slices)
      if (!is_known(slice.pose)) planes.push_back(slice.pose);
  for (const ContourStack& organ : organs)
    if (organ.slices.size() < planes.size())
      session.note(fmt::format("{}: {} of {} planes say nothing about it; the output says that it is absent there",
                               organ.name, planes.size() - organ.slices.size(), planes.size()));
}

void convert_contours(const ConvertCommand& command, Session& session) {
  const Format* format = find_format(command.output, &Format::write_contours);
  if (!format)
    throw_other_kind(command, "contours",
                     "use .vtp, .json, .csl, .contour or .dcm, or make surfaces with `reconstruct`");
  const std::vector<ContourStack> organs = organs_of(command, session);
  if (format->says_every_plane) note_planes_left_open(organs, session);
  note_dropped_organs(organs, command.output, session);
  write_contours(organs, command.output, write_options(command));
}

/// The mesh cut with the planes of --like.
void cut_mesh(const TriangleMesh& mesh, const ConvertCommand& command, Session& session) {
  ContourStack organ{.name = mesh.name, .slices = series_planes(write_options(command)), .color = mesh.color};
  std::size_t left_out = 0;
  for (ContourSlice& slice : organ.slices) {
    SectionLines lines = section_lines(mesh, slice.pose);
    slice.contours = std::move(lines.closed);
    left_out += lines.open.size();
  }
  if (left_out > 0)
    session.note(
        fmt::format("{}: the mesh is open; {} of its lines on the planes do not close and are left out; "
                    "`convert --mend` to a mesh closes it first",
                    command.path().string(), left_out));
  write_contours({organ}, command.output, write_options(command));
}

void convert_mesh(const ConvertCommand& command, Session& session) {
  TriangleMesh mesh = read_mesh(command.path(), command.input_axes == "ras" ? MeshAxes::ras : MeshAxes::lps);
  const bool as_contours = find_format(command.output, &Format::write_contours) && !command.like.series.empty();
  if (as_contours) return cut_mesh(mesh, command, session);
  if (!find_format(command.output, &Format::write_mesh))
    throw_other_kind(
        command, "a mesh",
        "use .stl, .ply, .obj, .vtp, .gltf or .glb, or give --like SERIES to cut it on that series' planes, "
        "or --voxel MM for a volume of its distances");
  if (command.retriangulation.any()) {
    RetriangulationReport report;
    mesh = retriangulate(mesh, command.retriangulation, report, nullptr, session.progress());
    session.result["retriangulation"] = to_json(report);
    session.text += to_text(report);
  }
  write_mesh(mesh, command.output, write_options(command));
}

void convert_labels(const ConvertCommand& command, Session& session) {
  if (find_format(command.output, &Format::write_contours) && !find_format(command.output, &Format::write_labels) &&
      read_label_planes(command.path()).size() > 1)  // contours are all that can hold them
    return write_contours(organs_in_labels(command.input, session), command.output, write_options(command));
  if (!find_format(command.output, &Format::write_labels))
    throw_other_kind(command, "labels", "use .nii.gz, .nrrd, .mha or .dcm, or trace contours with `segment`");
  const LabelMap labels = read_labels(command.path());
  for (const std::string& warning : labels.warnings) session.note(warning);
  write_organ_labels(labels, command.output, write_options(command), session);
}

void convert_volume(const ConvertCommand& command, Session& session) {
  if (!find_format(command.output, &Format::write_volume))
    throw_other_kind(command, "a volume", "use .nii.gz, .nrrd or .mha, or trace contours with `segment`");
  const StoredVolume volume = read_as_volume(command.input, session);
  for (const std::string& warning : volume.header.warnings) session.note(warning);
  write_volume(volume, command.output, write_options(command));
}

/// The name of what the input was, or became.
const char* convert_by_kind(const ConvertCommand& command, Session& session) {
  if (converts_body(command.path(), command.output, command.bodies)) {
    convert_body(command.path(), command.output, command.bodies, write_options(command), session);
    return find_format(command.output, &Format::write_volume) ? "distances" : "mesh";
  }
  const InputKind kind = kind_of(command.path(), command.output);
  switch (kind) {
    case InputKind::kContours:
      convert_contours(command, session);
      break;
    case InputKind::kMesh:
      convert_mesh(command, session);
      break;
    case InputKind::kLabels:
      convert_labels(command, session);
      break;
    case InputKind::kVolume:
      convert_volume(command, session);
      break;
  }
  return name_of(kind);
}

void run_convert(const ConvertCommand& command, Session& session) {
  if (command.input.paths.size() != 1)
    throw InputError("convert", "it takes one input", "convert the files one by one");
  const std::filesystem::path folder = command.output.has_parent_path() ? command.output.parent_path() : ".";
  if (!std::filesystem::is_directory(folder))
    throw InputError(command.output.string(), "its folder does not exist", "create " + folder.string());
  session.result["kind"] = convert_by_kind(command, session);
  session.result["output"] = command.output.string();
  session.wrote(command.output);
}

void add_axes(CLI::App& command, ConvertCommand& options) {
  command.add_option("--axes", options.axes, "World axes of a written mesh: lps (default) or ras; glTF has its own")
      ->check(CLI::IsMember({"lps", "ras"}));
  command.add_option("--input-axes", options.input_axes, "World axes of a mesh that is read: lps (default) or ras")
      ->check(CLI::IsMember({"lps", "ras"}));
}

}  // namespace

void add_convert(CLI::App& app, Session& session) {
  auto options = std::make_shared<ConvertCommand>();
  CLI::App* command = app.add_subcommand("convert", "From any format to another of the same kind");
  add_reading_options(*command, options->input);
  command
      ->add_option("-o,--output", options->output,
                   "Mesh, contours, labels or volume, as the input is, or distances; by extension, see docs/formats.md")
      ->check(written_path())
      ->required()
      ->type_name("OUT");
  add_like_options(*command, options->like);
  add_axes(*command, *options);
  add_body_options(*command, options->bodies);
  add_retriangulation_options(*command, options->retriangulation);
  command->callback([options, &session] { session.run = [options, &session] { run_convert(*options, session); }; });
}

}  // namespace isostack::cli
