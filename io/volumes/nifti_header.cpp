#include "io/volumes/nifti_header.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// Where the fields of one NIfTI version lie, in bytes.
struct Layout {
  int header_bytes, magic, dim, dim_bytes, datatype, pixdim, real_bytes, vox_offset, slope, units, units_bytes,
      qform_code, sform_code, code_bytes, quatern, sform, intent_name;
};
constexpr Layout nifti1 = {348, 344, 40, 2, 70, 76, 4, 108, 112, 123, 1, 252, 254, 2, 256, 280, 328};
constexpr Layout nifti2 = {540, 4, 16, 8, 12, 104, 8, 168, 176, 500, 4, 344, 348, 4, 352, 400, 508};

/// The bytes of a header and how to read numbers from them.
class Fields {
 public:
  explicit Fields(const std::filesystem::path& path);

  bool swapped() const { return swapped_; }
  bool compressed() const { return compressed_; }
  const Layout& layout() const { return *layout_; }
  std::string_view magic() const { return {bytes_.data() + layout_->magic, 4}; }
  std::string_view intent_name() const { return {bytes_.data() + layout_->intent_name, 16}; }
  std::int64_t whole(int at, int bytes) const {
    switch (bytes) {
      case 1:
        return number<std::int8_t>(at);
      case 2:
        return number<std::int16_t>(at);
      case 4:
        return number<std::int32_t>(at);
      default:
        return number<std::int64_t>(at);
    }
  }
  double real(int at, int index = 0) const {
    return layout_->real_bytes == 4 ? static_cast<double>(number<float>(at + 4 * index))
                                    : number<double>(at + 8 * index);
  }
  std::int64_t dim(int index) const { return whole(layout_->dim + index * layout_->dim_bytes, layout_->dim_bytes); }
  double pixdim(int index) const { return real(layout_->pixdim, index); }
  int code(int at) const { return static_cast<int>(whole(at, layout_->code_bytes)); }

 private:
  template <class T>
  T number(int at) const {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes_.data() + at, sizeof(T));
    if (swapped_) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<T>(raw);
  }

  std::array<char, 540> bytes_{};
  const Layout* layout_ = &nifti1;
  bool swapped_ = false, compressed_ = false;
};

Fields::Fields(const std::filesystem::path& path) {
  gzFile file = gzopen(path.c_str(), "rb");  // reads plain files as well
  const int read = file ? gzread(file, bytes_.data(), bytes_.size()) : -1;
  compressed_ = file && gzdirect(file) == 0;
  if (file) gzclose(file);
  for (const Layout* layout : {&nifti1, &nifti2})
    for (const bool swapped : {false, true}) {
      swapped_ = swapped;
      layout_ = layout;
      if (number<std::int32_t>(0) == layout->header_bytes && read >= layout->header_bytes) return;
    }
  throw InputError(path.string(), "it has no NIfTI header", "it is truncated or another format; copy it again");
}

/// The scalar types; colours, complex numbers and the like are not among them.
struct ValueType {
  int code;
  const char* name;
};
constexpr ValueType value_types[] = {{2, "uint8"},    {4, "int16"},    {8, "int32"},    {16, "float"},
                                     {64, "double"},  {256, "int8"},   {512, "uint16"}, {768, "uint32"},
                                     {1024, "int64"}, {1280, "uint64"}};

const char* value_type_of(const Fields& fields, const std::string& where) {
  const auto code = static_cast<int>(fields.whole(fields.layout().datatype, 2));
  for (const ValueType& type : value_types)
    if (type.code == code) return type.name;
  throw InputError(where, fmt::format("its voxel type (NIfTI code {}) is not a grey value", code),
                   "convert it to integers or floats");
}

Eigen::Vector3i size_of(const Fields& fields, const std::string& where) {
  Eigen::Vector3i size = Eigen::Vector3i::Ones();
  const std::int64_t dimensions = fields.dim(0);
  if (dimensions < 2 || dimensions > 7)
    throw InputError(where, fmt::format("the header claims {} dimensions", dimensions), "repair the header");
  for (int i = 1; i <= dimensions; ++i) {
    const std::int64_t length = fields.dim(i);
    if (i <= 3)
      size[i - 1] = static_cast<int>(std::clamp<std::int64_t>(length, 0, 1 << 30));
    else if (length > 1)
      throw InputError(where, fmt::format("it has {} dimensions (axis {} holds {} volumes)", dimensions, i, length),
                       "give one 3D volume of it");
  }
  return size;
}

/// Section "method 2" of nifti1.h.
Eigen::Affine3d from_qform(const Fields& fields, bool flip_k) {
  const int at = fields.layout().quatern;
  const double b = fields.real(at, 0), c = fields.real(at, 1), d = fields.real(at, 2);
  const double a = std::sqrt(std::max(0.0, 1 - b * b - c * c - d * d));
  const Eigen::Vector3d voxel(fields.pixdim(1), fields.pixdim(2), flip_k ? -fields.pixdim(3) : fields.pixdim(3));
  Eigen::Affine3d ras = Eigen::Affine3d::Identity();
  ras.linear() = Eigen::Quaterniond(a, b, c, d).normalized().toRotationMatrix() * voxel.asDiagonal();
  ras.translation() = Eigen::Vector3d(fields.real(at, 3), fields.real(at, 4), fields.real(at, 5));
  return ras;
}

Eigen::Affine3d from_sform(const Fields& fields) {
  Eigen::Affine3d ras = Eigen::Affine3d::Identity();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) ras(row, column) = fields.real(fields.layout().sform, 4 * row + column);
  return ras;
}

double millimetres_per_unit(const Fields& fields) {
  switch (fields.whole(fields.layout().units, fields.layout().units_bytes) & 7) {
    case 1:
      return 1000;
    case 3:
      return 1e-3;
    default:
      return 1;
  }
}

void read_pose(const Fields& fields, NiftiHeader& header) {
  const bool flip_k = fields.pixdim(0) < 0;
  const int sform_code = fields.code(fields.layout().sform_code), qform_code = fields.code(fields.layout().qform_code);
  Eigen::Affine3d ras = Eigen::Affine3d::Identity();
  if (sform_code > 0) {
    ras = from_sform(fields);
  } else if (qform_code > 0) {
    ras = from_qform(fields, flip_k);
  } else {
    ras.linear().diagonal() << fields.pixdim(1), fields.pixdim(2), fields.pixdim(3);
    header.volume.warnings.push_back("no pose: the header has neither sform nor qform; only the voxel size is known");
  }
  if (sform_code > 0 && qform_code > 0) {
    const double differing_mm = (from_qform(fields, flip_k).matrix() - ras.matrix()).cwiseAbs().maxCoeff();
    if (differing_mm > 0.1)
      header.volume.warnings.push_back(
          fmt::format("differing poses: sform and qform differ by up to {:.2f} mm; the sform is used", differing_mm));
  }
  header.volume.grid.index_to_world = lps_from_ras(Eigen::Scaling(millimetres_per_unit(fields)) * ras);
}

}  // namespace

NiftiHeader parse_nifti_header(const std::filesystem::path& path) {
  const std::string where = path.string();
  const Fields fields(path);
  NiftiHeader header;
  if (!fields.magic().starts_with("n+"))
    throw InputError(where, "it is a header without voxels (ANALYZE or .hdr/.img)", "convert it to one .nii file");
  header.volume.grid.size = size_of(fields, where);
  header.volume.value_type = value_type_of(fields, where);
  const double slope = fields.real(fields.layout().slope), intercept = fields.real(fields.layout().slope, 1);
  if (std::isfinite(slope) && slope != 0) {
    header.volume.slope = slope;
    header.volume.intercept = std::isfinite(intercept) ? intercept : 0;
  }
  read_pose(fields, header);
  header.volume.is_distance = fields.intent_name().starts_with(distance_mark);
  if (header.volume.grid.size.z() == 1) {  // a single image may leave its slice distance at 0
    auto axes_mm = header.volume.grid.index_to_world.linear();
    if (axes_mm.col(2).norm() < 1e-6) axes_mm.col(2) = axes_mm.col(0).cross(axes_mm.col(1)).normalized();
  }
  const double offset = fields.layout().real_bytes == 4
                            ? fields.real(fields.layout().vox_offset)
                            : static_cast<double>(fields.whole(fields.layout().vox_offset, 8));
  header.voxels = {
      .path = path,
      .compressed = fields.compressed(),
      .offset_bytes = offset > 0 ? static_cast<std::uintmax_t>(std::min(offset, 1e15)) : 0,  // it may be NaN
      .offset_is_inflated = true,
      .swapped = fields.swapped()};
  header.extensions_begin = static_cast<std::uintmax_t>(fields.layout().header_bytes);
  check_volume_header(header.volume, header.voxels, where);
  return header;
}

}  // namespace isostack
