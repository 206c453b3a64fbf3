#include <fmt/format.h>

#include <bit>

#include "io/volumes/nrrd.h"
#include "io/volumes/nrrd_segments.h"
#include "io/volumes/voxel_decoder.h"
#include "io/volumes/voxel_output.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

std::string vector_text(const Eigen::Vector3d& v) { return fmt::format("({},{},{})", v.x(), v.y(), v.z()); }

/// Everything up to the encoding.
std::string first_lines(const VolumeHeader& header) {
  const Eigen::Vector3i& size = header.grid.size;
  const Eigen::Affine3d& map = header.grid.index_to_world;
  const bool layered = header.components > 1;
  std::string lines = "NRRD0005\n# Complete NRRD file format specification at:\n# http://teem.sourceforge.net/nrrd/\n";
  lines += fmt::format("type: {}\ndimension: {}\nspace: left-posterior-superior\n", header.value_type, layered ? 4 : 3);
  if (header.is_distance) lines += fmt::format("content: {}, mm, positive inside\n", distance_mark);
  lines += fmt::format("sizes: {}{} {} {}\n", layered ? fmt::format("{} ", header.components) : "", size.x(), size.y(),
                       size.z());
  lines += fmt::format("space directions: {}{} {} {}\n", layered ? "none " : "", vector_text(map.linear().col(0)),
                       vector_text(map.linear().col(1)), vector_text(map.linear().col(2)));
  lines += fmt::format("kinds: {}domain domain domain\n", layered ? "list " : "");
  if (bytes_of_type(header.value_type) > 1)
    lines += fmt::format("endian: {}\n", std::endian::native == std::endian::big ? "big" : "little");
  return lines + "space origin: " + vector_text(map.translation()) + "\n";
}

void write(const VolumeHeader& header, const std::string& more, std::span<const char> voxels,
           const std::filesystem::path& path, const WriteOptions& options) {
  const std::string text = first_lines(header) + fmt::format("encoding: {}\n", options.compressed ? "gzip" : "raw");
  const std::string bytes = options.compressed ? deflated(voxels, Deflate::gzip) : std::string();
  if (options.compressed) voxels = bytes;
  if (path.extension() != ".nhdr") return write_header_and_voxels(path, text + more + "\n", voxels);
  std::filesystem::path beside = path;
  beside.replace_extension(options.compressed ? ".raw.gz" : ".raw");
  write_header_and_voxels(beside, "", voxels);
  write_header_and_voxels(path, text + more + fmt::format("data file: {}\n", beside.filename().string()), {});
}

}  // namespace

void write_nrrd(const StoredVolume& volume, const std::filesystem::path& path, const WriteOptions& options) {
  const StoredVolume plain = with_rescale_applied(volume);
  write(plain.header, "", plain.bytes, path, options);
}

void write_nrrd_labels(const LabelMap& labels, const std::filesystem::path& path, const WriteOptions& options) {
  if (labels.layers.empty()) throw InputError(path.string(), "there are no labels to write", "give a label map");
  VolumeHeader header;
  header.grid = labels.layers.front().grid;
  header.components = static_cast<int>(labels.layers.size());
  const std::string voxels = interleaved_labels(labels, header.value_type);
  write(header, nrrd_segment_lines(labels), voxels, path, options);
}

}  // namespace isostack
