#include "io/volumes/metaimage.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <string_view>

#include "io/volumes/label_values.h"
#include "io/volumes/text_header.h"
#include "io/volumes/voxel_decoder.h"
#include "io/volumes/voxel_output.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

struct ValueType {
  std::string_view key, name;
};
constexpr ValueType value_types[] = {{"met_char", "int8"},       {"met_uchar", "uint8"},       {"met_short", "int16"},
                                     {"met_ushort", "uint16"},   {"met_int", "int32"},         {"met_uint", "uint32"},
                                     {"met_long_long", "int64"}, {"met_ulong_long", "uint64"}, {"met_float", "float"},
                                     {"met_double", "double"}};

/// The first of the keys that is there: MetaImage has several names for the same thing.
std::vector<double> first_of(const TextHeader& fields, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (auto numbers = fields.numbers(key); !numbers.empty()) return numbers;
  return {};
}

void read_size_and_type(const TextHeader& fields, VolumeHeader& volume, const std::string& where) {
  const std::vector<double> sizes = fields.numbers("dimsize");
  if ((sizes.size() != 2 && sizes.size() != 3) || fields.numbers("ndims") != std::vector{double(sizes.size())})
    throw InputError(where, fmt::format("it has {} dimensions", sizes.size()), "give one 2D or 3D volume");
  volume.grid.size = whole_sizes(sizes);
  const std::vector<double> channels = fields.numbers("elementnumberofchannels");
  if (!channels.empty() && channels.front() != 1)
    throw InputError(where, fmt::format("it has {} values per voxel", channels.front()), "give grey values or labels");
  for (const ValueType& type : value_types)
    if (fields.lower("elementtype") == type.key) {
      volume.value_type = type.name;
      return;
    }
  throw InputError(where, "its voxel type '" + fields.text("elementtype") + "' is not a grey value",
                   "convert it to integers or floats");
}

/// The text holds the direction of the first axis, then of the second, and so on.
void read_pose(const TextHeader& fields, VolumeHeader& volume, const std::string& where) {
  const std::size_t n = fields.numbers("dimsize").size();
  const std::vector<double> spacing = first_of(fields, {"elementspacing", "elementsize"});
  const std::vector<double> origin = first_of(fields, {"offset", "position", "origin"});
  const std::vector<double> directions = first_of(fields, {"transformmatrix", "rotation", "orientation"});
  const auto fits = [](const std::vector<double>& numbers, std::size_t count) {
    return numbers.empty() || numbers.size() == count;
  };
  if (!fits(spacing, n) || !fits(origin, n) || !fits(directions, n * n))
    throw InputError(where, "its spacing, offset or directions have the wrong number of values", "repair the header");
  if (directions.empty())
    volume.warnings.push_back("no orientation: the header has no directions; LPS axes are assumed");
  Eigen::Affine3d& index_to_world = volume.grid.index_to_world;
  for (std::size_t axis = 0; axis < n; ++axis) {
    const auto column = static_cast<int>(axis);
    if (!origin.empty()) index_to_world.translation()[column] = origin[axis];
    for (std::size_t i = 0; i < n && !directions.empty(); ++i)
      index_to_world.linear()(static_cast<int>(i), column) = directions[axis * n + i];
    if (!spacing.empty()) index_to_world.linear().col(column) *= spacing[axis];
  }
}

VoxelFile find_voxels(const TextHeader& fields, const std::filesystem::path& path) {
  if (fields.lower("binarydata") == "false")
    throw InputError(path.string(), "its voxels are text", "save it with BinaryData = True");
  const std::string file = fields.text("elementdatafile");
  const std::string skip = fields.text("headersize");
  if (file.starts_with("LIST") || file.find('%') != std::string::npos || (!skip.empty() && skip != "0"))
    throw InputError(path.string(), "its voxels are spread over several files or begin after a skip",
                     "save it as one .mha file");
  VoxelFile voxels = {
      .path = path, .compressed = fields.lower("compresseddata") == "true", .offset_bytes = fields.bytes};
  if (file != "LOCAL") {
    voxels.path = path.parent_path() / file;
    voxels.offset_bytes = 0;
  }
  const bool is_big = fields.lower("binarydatabyteordermsb") == "true" || fields.lower("elementbyteordermsb") == "true";
  voxels.swapped = is_big != (std::endian::native == std::endian::big);
  return voxels;
}

struct MetaImageHeader {
  VolumeHeader volume;
  VoxelFile voxels;
};

MetaImageHeader parse_header(const std::filesystem::path& path) {
  const std::string where = path.string();
  const TextHeader fields = read_text_header(path, {.separator = '=', .last_key = "elementdatafile"});
  MetaImageHeader header;
  read_size_and_type(fields, header.volume, where);
  read_pose(fields, header.volume, where);
  header.volume.is_distance = fields.text("comment").starts_with(distance_mark);
  header.voxels = find_voxels(fields, path);
  check_volume_header(header.volume, header.voxels, where);
  return header;
}

}  // namespace

VolumeHeader read_metaimage_header(const std::filesystem::path& path) { return parse_header(path).volume; }

Volume<float> read_metaimage(const std::filesystem::path& path) {
  const MetaImageHeader header = parse_header(path);
  Volume<float> volume;
  volume.grid = header.volume.grid;
  volume.voxels = read_voxels(header.volume, header.voxels, path.string());
  return volume;
}

StoredVolume read_stored_metaimage(const std::filesystem::path& path) {
  const MetaImageHeader header = parse_header(path);
  return read_stored_voxels(header.volume, header.voxels, path.string());
}

LabelMap read_metaimage_labels(const std::filesystem::path& path) {
  return label_map_of(read_stored_metaimage(path), path.string());
}

namespace {

std::string header_text(const VolumeHeader& header) {
  const Eigen::Affine3d& map = header.grid.index_to_world;
  const Eigen::Vector3d spacing_mm = map.linear().colwise().norm();
  std::string directions;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 3; ++i) directions += fmt::format(" {}", map.linear()(i, axis) / spacing_mm[axis]);
  std::string type;
  for (const ValueType& known : value_types)
    if (known.name == header.value_type) type = known.key;
  std::transform(type.begin(), type.end(), type.begin(), [](unsigned char c) { return std::toupper(c); });
  const std::string comment =
      header.is_distance ? fmt::format("Comment = {}, mm, positive inside\n", distance_mark) : "";
  return fmt::format(
      "ObjectType = Image\nNDims = 3\n{}BinaryData = True\nBinaryDataByteOrderMSB = {}\nTransformMatrix ={}\n"
      "Offset = {} {} {}\nCenterOfRotation = 0 0 0\nElementSpacing = {} {} {}\nDimSize = {} {} {}\nElementType = {}\n",
      comment, std::endian::native == std::endian::big ? "True" : "False", directions, map.translation().x(),
      map.translation().y(), map.translation().z(), spacing_mm.x(), spacing_mm.y(), spacing_mm.z(),
      header.grid.size.x(), header.grid.size.y(), header.grid.size.z(), type);
}

void write(const VolumeHeader& header, std::span<const char> voxels, const std::filesystem::path& path,
           const WriteOptions& options) {
  std::string text = header_text(header);
  const std::string bytes = options.compressed ? deflated(voxels, Deflate::zlib) : std::string();
  if (options.compressed) {
    voxels = bytes;
    text += fmt::format("CompressedData = True\nCompressedDataSize = {}\n", bytes.size());
  }
  if (path.extension() != ".mhd") return write_header_and_voxels(path, text + "ElementDataFile = LOCAL\n", voxels);
  std::filesystem::path beside = path;
  beside.replace_extension(options.compressed ? ".zraw" : ".raw");
  write_header_and_voxels(beside, "", voxels);
  write_header_and_voxels(path, text + fmt::format("ElementDataFile = {}\n", beside.filename().string()), {});
}

}  // namespace

void write_metaimage(const StoredVolume& volume, const std::filesystem::path& path, const WriteOptions& options) {
  const StoredVolume plain = with_rescale_applied(volume);
  write(plain.header, plain.bytes, path, options);
}

void write_metaimage_labels(const LabelMap& labels, const std::filesystem::path& path, const WriteOptions& options) {
  VolumeHeader header;
  header.grid = single_layer(labels, path.string(), "MetaImage").grid;
  const std::string voxels = interleaved_labels(labels, header.value_type);
  write(header, voxels, path, options);
}

}  // namespace isostack
