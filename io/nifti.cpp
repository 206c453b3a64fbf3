#include "io/nifti.h"

#include <zlib.h>

#include <Eigen/Geometry>
#include <array>
#include <cstring>

#include "io/atomic_file.h"
#include "io/nifti_header.h"
#include "io/voxel_decoder.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// The 348 bytes of a NIfTI-1 header and the 4 that say "no extension".
class HeaderBytes {
 public:
  template <class T>
  void put(int at, std::initializer_list<T> values) {
    for (const T value : values) {
      std::memcpy(bytes_.data() + at, &value, sizeof(T));
      at += static_cast<int>(sizeof(T));
    }
  }
  const std::array<char, 352>& bytes() const { return bytes_; }

 private:
  std::array<char, 352> bytes_{};
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

HeaderBytes header_for(const Grid& grid) {
  HeaderBytes header;
  header.put<std::int32_t>(0, {348});
  const Eigen::Matrix<std::int16_t, 3, 1> size = grid.size.cast<std::int16_t>();
  header.put<std::int16_t>(40, {3, size.x(), size.y(), size.z(), 1, 1, 1, 1});  // dim
  header.put<std::int16_t>(70, {512, 16});                                      // uint16, 16 bits
  const Eigen::Affine3d ras = lps_from_ras(grid.index_to_world);                // the map is its own inverse
  put_qform(ras, grid.index_to_world.linear().colwise().norm(), header);
  header.put<float>(108, {352, 1, 0});  // vox_offset, slope, intercept
  header.put<char>(123, {2});           // mm
  header.put<std::int16_t>(254, {1});   // sform_code: scanner
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      header.put<float>(280 + 4 * (4 * row + column), {static_cast<float>(ras(row, column))});
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

}  // namespace

VolumeHeader read_nifti_header(const std::filesystem::path& path) { return parse_nifti_header(path).volume; }

Volume<float> read_nifti(const std::filesystem::path& path) {
  const NiftiHeader header = parse_nifti_header(path);
  Volume<float> volume;
  volume.grid = header.volume.grid;
  volume.voxels = read_voxels(header.volume, header.voxels, path.string());
  return volume;
}

void write_nifti_labels(const LabelMap& map, const std::filesystem::path& path, const WriteOptions& /*options*/) {
  if (map.layers.size() != 1)
    throw InputError(path.string(), "NIfTI labels cannot overlap", "write .seg.nrrd or one file per organ");
  const LabelVolume& labels = map.layers.front();
  if (labels.grid.size.minCoeff() < 1 || labels.grid.size.maxCoeff() > INT16_MAX)
    throw InputError(path.string(), "NIfTI-1 holds 1 to 32767 voxels along each axis", "choose another grid");
  AtomicFile file(path);
  const HeaderBytes header = header_for(labels.grid);
  Output output(file.temporary(), path.extension() == ".gz");
  const bool written = output.write(header.bytes().data(), header.bytes().size()) &&
                       output.write(labels.voxels.data(), labels.voxels.size() * sizeof(std::uint16_t));
  if (!output.close() || !written)
    throw InputError(path.string(), "it cannot be written to the end", "check that the disk has free space");
  file.commit();
}

}  // namespace isostack
