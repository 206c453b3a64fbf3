#include "io/volumes/nifti.h"

#include <zlib.h>

#include <Eigen/Geometry>
#include <array>
#include <cstring>
#include <span>

#include "io/atomic_file.h"
#include "io/volumes/label_values.h"
#include "io/volumes/nifti_header.h"
#include "io/volumes/nifti_label_names.h"
#include "io/volumes/voxel_decoder.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr int header_bytes = 348;

/// A NIfTI-1 header.
class HeaderBytes {
 public:
  template <class T>
  void put(int at, std::initializer_list<T> values) {
    for (const T value : values) {
      std::memcpy(bytes_.data() + at, &value, sizeof(T));
      at += static_cast<int>(sizeof(T));
    }
  }
  const std::array<char, header_bytes>& bytes() const { return bytes_; }

 private:
  std::array<char, header_bytes> bytes_{};
};

void put_qform(const Eigen::Affine3d& ras, const Eigen::Vector3d& voxel_mm, HeaderBytes& header) {
  Eigen::Matrix3d axes = ras.linear() * voxel_mm.cwiseInverse().asDiagonal();
  const bool is_left_handed = axes.determinant() < 0;
  if (is_left_handed) axes.col(2) *= -1;
  const bool is_sheared = !axes.isUnitary(1e-4);
  Eigen::Quaterniond rotation(axes);
  if (rotation.w() < 0) rotation.coeffs() *= -1;
  const Eigen::Vector3f voxel = voxel_mm.cast<float>();
  header.put<float>(76, {is_left_handed ? -1.0f : 1.0f, voxel.x(), voxel.y(), voxel.z(), 1, 1, 1, 1});  // pixdim
  if (is_sheared) return;
  header.put<std::int16_t>(252, {1});  // qform_code: scanner
  header.put<float>(256, {static_cast<float>(rotation.x()), static_cast<float>(rotation.y()),
                          static_cast<float>(rotation.z()), static_cast<float>(ras.translation().x()),
                          static_cast<float>(ras.translation().y()), static_cast<float>(ras.translation().z())});
}

struct ValueType {
  const char* name;
  std::int16_t code, bits;
};
constexpr ValueType value_types[] = {{"uint8", 2, 8},     {"int16", 4, 16},    {"int32", 8, 32},    {"float", 16, 32},
                                     {"double", 64, 64},  {"int8", 256, 8},    {"uint16", 512, 16}, {"uint32", 768, 32},
                                     {"int64", 1024, 64}, {"uint64", 1280, 64}};

HeaderBytes header_for(const VolumeHeader& volume, std::size_t voxel_offset) {
  const Grid& grid = volume.grid;
  HeaderBytes header;
  header.put<std::int32_t>(0, {header_bytes});
  const Eigen::Matrix<std::int16_t, 3, 1> size = grid.size.cast<std::int16_t>();
  header.put<std::int16_t>(40, {3, size.x(), size.y(), size.z(), 1, 1, 1, 1});  // dim
  for (const ValueType& type : value_types)
    if (type.name == volume.value_type) header.put<std::int16_t>(70, {type.code, type.bits});
  const Eigen::Affine3d ras = lps_from_ras(grid.index_to_world);  // the map is its own inverse
  put_qform(ras, grid.index_to_world.linear().colwise().norm(), header);
  header.put<float>(
      108, {static_cast<float>(voxel_offset), static_cast<float>(volume.slope), static_cast<float>(volume.intercept)});
  header.put<char>(123, {2});          // mm
  header.put<std::int16_t>(254, {1});  // sform_code: scanner
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      header.put<float>(280 + 4 * (4 * row + column), {static_cast<float>(ras(row, column))});
  if (volume.is_distance)  // intent_name
    for (std::size_t i = 0; i < distance_mark.size(); ++i)
      header.put<char>(328 + static_cast<int>(i), {distance_mark[i]});
  header.put<char>(344, {'n', '+', '1', '\0'});
  return header;
}

/// Plain or compressed bytes through one interface: "T" makes zlib write without compressing.
class Output {
 public:
  Output(const std::filesystem::path& path, bool compressed)
      : file_(gzopen(path.c_str(), compressed ? "wb6" : "wbT")) {}
  ~Output() { close(); }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  bool write(const void* data, std::size_t bytes) { return file_ && gzfwrite(data, 1, bytes, file_) == bytes; }
  bool close() {
    const bool closed = !file_ || gzclose(file_) == Z_OK;
    file_ = nullptr;
    return closed;
  }

 private:
  gzFile file_;
};

void require_writable_size(const Grid& grid, const std::filesystem::path& path) {
  if (grid.size.minCoeff() < 1 || grid.size.maxCoeff() > INT16_MAX)
    throw InputError(path.string(), "NIfTI-1 holds 1 to 32767 voxels along each axis", "choose another grid");
}

void write(const HeaderBytes& header, std::string_view extension, std::span<const char> voxels,
           const std::filesystem::path& path) {
  AtomicFile file(path);
  Output output(file.temporary(), path.extension() == ".gz");
  const bool written = output.write(header.bytes().data(), header.bytes().size()) &&
                       output.write(extension.data(), extension.size()) && output.write(voxels.data(), voxels.size());
  if (!output.close() || !written)
    throw InputError(path.string(), "it cannot be written to the end", "check that the disk has free space");
  file.commit();
}

bool is_float(double value) { return static_cast<double>(static_cast<float>(value)) == value; }

}  // namespace

VolumeHeader read_nifti_header(const std::filesystem::path& path) { return parse_nifti_header(path).volume; }

Volume<float> read_nifti(const std::filesystem::path& path) {
  const NiftiHeader header = parse_nifti_header(path);
  Volume<float> volume;
  volume.grid = header.volume.grid;
  volume.voxels = read_voxels(header.volume, header.voxels, path.string());
  return volume;
}

StoredVolume read_stored_nifti(const std::filesystem::path& path) {
  const NiftiHeader header = parse_nifti_header(path);
  return read_stored_voxels(header.volume, header.voxels, path.string());
}

LabelMap read_nifti_labels(const std::filesystem::path& path) {
  const NiftiHeader header = parse_nifti_header(path);
  LabelMap map = label_map_of(read_stored_voxels(header.volume, header.voxels, path.string()), path.string());
  const std::vector<Segment> named = read_nifti_label_names(header);
  map.segments.insert(map.segments.end(), named.begin(), named.end());
  return map;
}

void write_nifti(const StoredVolume& volume, const std::filesystem::path& path, const WriteOptions& /*options*/) {
  require_writable_size(volume.header.grid, path);
  const bool fits = is_float(volume.header.slope) && is_float(volume.header.intercept) && volume.header.slope != 0;
  const StoredVolume stored = fits ? volume : with_rescale_applied(volume);
  const std::string no_extension = nifti_label_extension({});
  write(header_for(stored.header, header_bytes + no_extension.size()), no_extension, stored.bytes, path);
}

void write_nifti_labels(const LabelMap& map, const std::filesystem::path& path, const WriteOptions& /*options*/) {
  const LabelVolume& labels = single_layer(map, path.string(), "NIfTI");
  require_writable_size(labels.grid, path);
  VolumeHeader volume;
  volume.grid = labels.grid;
  volume.value_type = "uint16";
  const std::string extension = nifti_label_extension(map.segments);
  HeaderBytes header = header_for(volume, header_bytes + extension.size());
  constexpr std::int16_t label_intent = 1002;
  header.put<std::int16_t>(68, {label_intent});
  const std::span<const char> voxels(reinterpret_cast<const char*>(labels.voxels.data()), labels.voxels.size() * 2);
  write(header, extension, voxels, path);
}

}  // namespace isostack
