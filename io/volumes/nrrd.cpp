#include "io/volumes/nrrd.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "io/volumes/label_values.h"
#include "io/volumes/nrrd_segments.h"
#include "io/volumes/text_header.h"
#include "io/volumes/voxel_decoder.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

struct NrrdHeader {
  VolumeHeader volume;
  VoxelFile voxels;
};

struct ValueType {
  const char* names;  ///< all spellings, each between bars
  const char* name;
};
constexpr ValueType value_types[] = {
    {"|signed char|int8|int8_t|", "int8"},
    {"|uchar|unsigned char|uint8|uint8_t|", "uint8"},
    {"|short|short int|signed short|signed short int|int16|int16_t|", "int16"},
    {"|ushort|unsigned short|unsigned short int|uint16|uint16_t|", "uint16"},
    {"|int|signed int|int32|int32_t|", "int32"},
    {"|uint|unsigned int|uint32|uint32_t|", "uint32"},
    {"|longlong|long long|long long int|signed long long|signed long long int|int64|int64_t|", "int64"},
    {"|ulonglong|unsigned long long|unsigned long long int|uint64|uint64_t|", "uint64"},
    {"|float|", "float"},
    {"|double|", "double"},
};

/// "key: value" lines after the magic, up to the empty line before attached voxels.
TextHeader read_fields(const std::filesystem::path& path) {
  TextHeader header = read_text_header(path, {.separator = ':', .ends_at_empty_line = true});
  if (!header.first_line.starts_with("NRRD000"))
    throw InputError(path.string(), "it does not start as a NRRD file", "it is truncated or another format");
  return header;
}

void read_type(const TextHeader& fields, VolumeHeader& volume, const std::string& where) {
  const std::string bars = fmt::format("|{}|", fields.lower("type"));
  for (const ValueType& type : value_types)
    if (std::string_view(type.names).find(bars) != std::string_view::npos) {
      volume.value_type = type.name;
      return;
    }
  throw InputError(where, fmt::format("its voxel type '{}' is not a grey value", fields.lower("type")),
                   "convert it to integers or floats");
}

/// Layers of labels come as a first axis that has no direction ("none").
bool has_layers(const TextHeader& fields) {
  return fields.numbers("sizes").size() == 4 && fields.lower("space directions").starts_with("none");
}

/// Sizes along the axes of space.
std::vector<double> space_sizes(const TextHeader& fields) {
  std::vector<double> sizes = fields.numbers("sizes");
  if (has_layers(fields)) sizes.erase(sizes.begin());
  return sizes;
}

void read_size(const TextHeader& fields, VolumeHeader& volume, const std::string& where) {
  const std::vector<double> sizes = fields.numbers("sizes"), in_space = space_sizes(fields);
  const bool is_volume = in_space.size() == 2 || in_space.size() == 3;
  if (!is_volume || fields.numbers("dimension") != std::vector{double(sizes.size())})
    throw InputError(where, fmt::format("it has {} dimensions", sizes.size()),
                     "give one 2D or 3D volume of grey values or labels");
  volume.grid.size = whole_sizes(in_space);
  if (!has_layers(fields)) return;
  volume.components = whole_sizes({sizes.front()}).x();
  if (volume.components < 1 || volume.components > 65535)
    throw InputError(where, fmt::format("the header claims {:g} layers", sizes.front()), "repair the header");
}

/// "(1,0,0) none (0,1,0)" as vectors; "none" is left out.
std::vector<Eigen::Vector3d> vectors_in(const std::string& text) {
  std::vector<Eigen::Vector3d> vectors;
  for (std::size_t open = text.find('('); open != std::string::npos; open = text.find('(', open + 1)) {
    std::string inner = text.substr(open + 1, text.find(')', open) - open - 1);
    std::replace(inner.begin(), inner.end(), ',', ' ');
    const std::vector<double> values = parse_numbers(inner);
    if (values.size() == 3) vectors.emplace_back(values[0], values[1], values[2]);
  }
  return vectors;
}

/// Signs that turn the first two axes of the space into left and posterior.
Eigen::Vector3d lps_signs(const TextHeader& fields, VolumeHeader& volume, const std::string& where) {
  const std::string space = fields.lower("space");
  if (space == "left-posterior-superior" || space == "lps") return {1, 1, 1};
  if (space == "right-anterior-superior" || space == "ras") return {-1, -1, 1};
  if (space == "left-anterior-superior" || space == "las") return {1, -1, 1};
  if (space.empty() || space.starts_with("scanner-xyz") || space == "3d-right-handed" || space == "3d-left-handed") {
    volume.warnings.push_back("no patient space: the header does not name patient directions; LPS is assumed");
    return {1, 1, 1};
  }
  throw InputError(where, "its space '" + space + "' is not supported", "convert it to left-posterior-superior");
}

void read_pose(const TextHeader& fields, VolumeHeader& volume, const std::string& where) {
  const std::size_t dimensions = space_sizes(fields).size();
  const Eigen::Vector3d signs = lps_signs(fields, volume, where);
  auto directions = vectors_in(fields.text("space directions"));
  if (fields.text("space directions").empty()) {
    const std::vector<double> spacings = fields.numbers("spacings");
    for (std::size_t axis = 0; axis < dimensions; ++axis)
      directions.push_back(Eigen::Vector3d::Unit(static_cast<int>(axis)) *
                           (spacings.size() == dimensions ? spacings[axis] : 1));
  }
  if (directions.size() != dimensions)
    throw InputError(where, "its space directions do not belong to a 3D space", "repair the header");
  if (dimensions == 2) directions.push_back(directions[0].cross(directions[1]).normalized());
  const auto origins = vectors_in(fields.text("space origin"));
  for (int axis = 0; axis < 3; ++axis)
    volume.grid.index_to_world.linear().col(axis) = signs.cwiseProduct(directions[static_cast<std::size_t>(axis)]);
  if (!origins.empty()) volume.grid.index_to_world.translation() = signs.cwiseProduct(origins.front());
}

VoxelFile find_voxels(const TextHeader& fields, const std::filesystem::path& path) {
  const std::string encoding = fields.lower("encoding");
  VoxelFile voxels = {.path = path, .compressed = encoding == "gzip" || encoding == "gz", .offset_bytes = fields.bytes};
  if (!voxels.compressed && encoding != "raw")
    throw InputError(path.string(), "its encoding '" + encoding + "' is not supported", "save it as raw or gzip");
  const bool skips = !fields.text("byte skip").empty() || !fields.text("line skip").empty();
  const std::string data_file = fields.text("data file") + fields.text("datafile");
  if (skips || data_file.starts_with("LIST") || data_file.find('%') != std::string::npos)
    throw InputError(path.string(), "its voxels are spread over several files or begin after a skip",
                     "save it as one .nrrd file");
  if (!data_file.empty()) {
    voxels.path = path.parent_path() / data_file;
    voxels.offset_bytes = 0;
  }
  voxels.swapped = (fields.lower("endian") == "big") != (std::endian::native == std::endian::big);
  return voxels;
}

NrrdHeader parse_header(const TextHeader& fields, const std::filesystem::path& path) {
  const std::string where = path.string();
  NrrdHeader header;
  read_size(fields, header.volume, where);
  read_type(fields, header.volume, where);
  read_pose(fields, header.volume, where);
  header.volume.is_distance = fields.text("content").starts_with(distance_mark);
  header.voxels = find_voxels(fields, path);
  check_volume_header(header.volume, header.voxels, where);
  return header;
}

}  // namespace

VolumeHeader read_nrrd_header(const std::filesystem::path& path) {
  return parse_header(read_fields(path), path).volume;
}

Volume<float> read_nrrd(const std::filesystem::path& path) {
  const NrrdHeader header = parse_header(read_fields(path), path);
  Volume<float> volume;
  volume.grid = header.volume.grid;
  volume.voxels = read_voxels(header.volume, header.voxels, path.string());
  return volume;
}

StoredVolume read_stored_nrrd(const std::filesystem::path& path) {
  const NrrdHeader header = parse_header(read_fields(path), path);
  return read_stored_voxels(header.volume, header.voxels, path.string());
}

LabelMap read_nrrd_labels(const std::filesystem::path& path) {
  const TextHeader fields = read_fields(path);
  const NrrdHeader header = parse_header(fields, path);
  LabelMap map = label_map_of(read_stored_voxels(header.volume, header.voxels, path.string()), path.string());
  add_nrrd_segments(fields, map);
  return map;
}

}  // namespace isostack
