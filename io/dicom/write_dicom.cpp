#include "io/dicom/write_dicom.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "io/dicom/dicom_builder.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr const char* ct_image_storage = "1.2.840.10008.5.1.4.1.1.2";

/// SplitMix64 (Steele, Lea, Flood 2014): spreads neighbouring seeds over all 64 bits.
std::uint64_t mixed(std::uint64_t seed) {
  seed += 0x9e3779b97f4a7c15;
  seed = (seed ^ (seed >> 30)) * 0xbf58476d1ce4e5b9;
  seed = (seed ^ (seed >> 27)) * 0x94d049bb133111eb;
  return seed ^ (seed >> 31);
}

/// `what` tells the UIDs of a seed apart.
std::string uid_for(std::uint64_t seed, std::uint64_t what) {
  return uid_from(mixed(mixed(seed) ^ (2 * what)), mixed(mixed(seed) ^ (2 * what + 1)));
}
enum UidPurpose : std::uint64_t { kStudy, kSeries, kFrameOfReference, kFirstInstance };

void add_decimals(const gdcm::Tag& tag, std::initializer_list<double> values, DataSetBuilder& data) {
  data.text(tag, gdcm::VR::DS, fmt::format("{:.10g}", fmt::join(values, "\\")));
}

void add_patient_and_study(const DicomSeriesOptions& options, DataSetBuilder& data) {
  data.text({0x0010, 0x0010}, gdcm::VR::PN, "PHANTOM");
  data.text({0x0010, 0x0020}, gdcm::VR::LO, "PHANTOM");
  data.text({0x0010, 0x0030}, gdcm::VR::DA, "");  // birth date
  data.text({0x0010, 0x0040}, gdcm::VR::CS, "");  // sex
  data.text({0x0020, 0x000d}, gdcm::VR::UI, uid_for(options.seed, kStudy));
  data.text({0x0008, 0x0020}, gdcm::VR::DA, "");  // study date
  data.text({0x0008, 0x0030}, gdcm::VR::TM, "");  // study time
  data.text({0x0008, 0x0090}, gdcm::VR::PN, "");  // referring physician
  data.text({0x0020, 0x0010}, gdcm::VR::SH, "");  // study id
  data.text({0x0008, 0x0050}, gdcm::VR::SH, "");  // accession number
}

void add_series(const DicomSeriesOptions& options, DataSetBuilder& data) {
  data.text({0x0008, 0x0060}, gdcm::VR::CS, "CT");
  data.text({0x0020, 0x000e}, gdcm::VR::UI, uid_for(options.seed, kSeries));
  data.text({0x0020, 0x0011}, gdcm::VR::IS, std::to_string(options.series_number));
  data.text({0x0008, 0x103e}, gdcm::VR::LO, options.description.substr(0, 64));
  data.text({0x0018, 0x5100}, gdcm::VR::CS, "HFS");
  data.text({0x0020, 0x0052}, gdcm::VR::UI, uid_for(options.seed, kFrameOfReference));
  data.text({0x0020, 0x1040}, gdcm::VR::LO, "");  // position reference
  data.text({0x0008, 0x0070}, gdcm::VR::LO, "isostack");
}

void add_plane(const SlicePose& pose, const DicomSeriesOptions& options, DataSetBuilder& data) {
  const Eigen::Vector3d &o = pose.origin_mm, &x = pose.x_axis, &y = pose.y_axis;
  add_decimals({0x0020, 0x0032}, {o.x(), o.y(), o.z()}, data);
  add_decimals({0x0020, 0x0037}, {x.x(), x.y(), x.z(), y.x(), y.y(), y.z()}, data);
  add_decimals({0x0028, 0x0030}, {pose.spacing_mm.y(), pose.spacing_mm.x()}, data);  // distance between rows first
  if (options.slice_thickness_mm)
    add_decimals({0x0018, 0x0050}, {*options.slice_thickness_mm}, data);
  else
    data.text({0x0018, 0x0050}, gdcm::VR::DS, "");
}

std::vector<std::int16_t> stored_values(const Slice& slice, const DicomSeriesOptions& options) {
  std::vector<std::int16_t> stored;
  stored.reserve(static_cast<std::size_t>(slice.pixels.size()));
  for (Eigen::Index row = 0; row < slice.pixels.rows(); ++row)
    for (Eigen::Index column = 0; column < slice.pixels.cols(); ++column) {
      const double value = std::round((slice.pixels(row, column) - options.rescale_intercept) / options.rescale_slope);
      if (!(value >= INT16_MIN && value <= INT16_MAX))
        throw InputError(slice.name, fmt::format("the value {} does not fit into 16 bits", slice.pixels(row, column)),
                         "scale the slices or choose another rescale");
      stored.push_back(static_cast<std::int16_t>(value));
    }
  return stored;
}

void add_pixels(const Slice& slice, const DicomSeriesOptions& options, DataSetBuilder& data) {
  data.number({0x0028, 0x0002}, 1);
  data.text({0x0028, 0x0004}, gdcm::VR::CS, "MONOCHROME2");
  data.number({0x0028, 0x0010}, static_cast<std::uint16_t>(slice.pixels.rows()));
  data.number({0x0028, 0x0011}, static_cast<std::uint16_t>(slice.pixels.cols()));
  data.number({0x0028, 0x0100}, 16);
  data.number({0x0028, 0x0101}, 16);
  data.number({0x0028, 0x0102}, 15);
  data.number({0x0028, 0x0103}, 1);
  add_decimals({0x0028, 0x1052}, {options.rescale_intercept}, data);
  add_decimals({0x0028, 0x1053}, {options.rescale_slope}, data);
  const std::vector<std::int16_t> stored = stored_values(slice, options);
  data.bytes({0x7fe0, 0x0010}, gdcm::VR::OW, {reinterpret_cast<const char*>(stored.data()), stored.size() * 2});
}

gdcm::DataSet data_set_for(const Slice& slice, std::size_t index, const DicomSeriesOptions& options) {
  DataSetBuilder data;
  data.text({0x0008, 0x0016}, gdcm::VR::UI, ct_image_storage);
  data.text({0x0008, 0x0018}, gdcm::VR::UI, uid_for(options.seed, kFirstInstance + index));
  add_patient_and_study(options, data);
  add_series(options, data);
  data.text({0x0020, 0x0013}, gdcm::VR::IS, std::to_string(index + 1));
  data.text({0x0008, 0x0008}, gdcm::VR::CS, "DERIVED\\PRIMARY\\AXIAL");
  data.text({0x0018, 0x0060}, gdcm::VR::DS, "");  // KVP
  data.text({0x0020, 0x0012}, gdcm::VR::IS, "");  // acquisition number
  add_plane(slice.pose, options, data);
  add_pixels(slice, options, data);
  return data.result();
}

}  // namespace

void write_dicom_series(const SliceStack& stack, const std::filesystem::path& folder,
                        const DicomSeriesOptions& options) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder.string(), "the folder cannot be made (" + error.message() + ")", "choose another");
  for (std::size_t i = 0; i < stack.slices.size(); ++i) {
    const Slice& slice = stack.slices[i];
    if (slice.pixels.size() == 0) throw GeometryError(slice.name, "the slice has no pixels", "give slices with pixels");
    write_dicom_file(data_set_for(slice, i, options), folder / fmt::format("slice_{:04}.dcm", i + 1));
  }
}

}  // namespace isostack
