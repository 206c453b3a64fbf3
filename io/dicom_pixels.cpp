#include "io/dicom_pixels.h"

#include <fmt/format.h>
#include <gdcmImageReader.h>

#include <vector>

#include "io/gdcm_setup.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

void require_grey_single_frame(const DicomHeader& header) {
  if (header.samples_per_pixel != 1 || header.photometric == "PALETTE COLOR")
    throw InputError(header.name, fmt::format("the image is coloured ({})", header.photometric),
                     "give grey images; colour is not a measurement");
  if (header.frames != 1)
    throw InputError(header.name, fmt::format("the file holds {} frames", header.frames),
                     "multi-frame DICOM is not supported; convert it to one file per slice or to NIfTI");
}

[[noreturn]] void throw_undecodable(const DicomHeader& header) {
  throw InputError(header.name, fmt::format("its pixels cannot be decoded ({})", header.transfer_syntax),
                   "the file is cut off, damaged or of an unsupported compression; copy it again or decompress it");
}

template <class Stored>
Image<float> rescaled(const std::vector<char>& bytes, const DicomHeader& header) {
  using Raster = Image<Stored>;
  const Eigen::Map<const Raster> stored(reinterpret_cast<const Stored*>(bytes.data()), header.rows, header.columns);
  return (stored.template cast<double>() * header.slope + header.intercept).template cast<float>();
}

Image<float> rescaled(const std::vector<char>& bytes, gdcm::PixelFormat::ScalarType type, const DicomHeader& header) {
  switch (type) {
    case gdcm::PixelFormat::UINT8:
      return rescaled<std::uint8_t>(bytes, header);
    case gdcm::PixelFormat::INT8:
      return rescaled<std::int8_t>(bytes, header);
    case gdcm::PixelFormat::UINT16:
      return rescaled<std::uint16_t>(bytes, header);
    case gdcm::PixelFormat::INT16:
      return rescaled<std::int16_t>(bytes, header);
    case gdcm::PixelFormat::UINT32:
      return rescaled<std::uint32_t>(bytes, header);
    case gdcm::PixelFormat::INT32:
      return rescaled<std::int32_t>(bytes, header);
    default:
      throw InputError(header.name, fmt::format("pixels of {} bits are not supported", header.bits_allocated),
                       "convert the file to 8, 16 or 32 bits");
  }
}

}  // namespace

Image<float> read_dicom_pixels(const DicomHeader& header) {
  require_grey_single_frame(header);
  set_up_gdcm();
  gdcm::ImageReader reader;
  reader.SetFileName(header.path.c_str());
  if (!reader.Read()) throw_undecodable(header);
  const gdcm::Image& image = reader.GetImage();
  const gdcm::PixelFormat format = image.GetPixelFormat();
  const auto pixel_count = static_cast<std::size_t>(header.rows) * static_cast<std::size_t>(header.columns);
  const bool as_announced = image.GetDimension(0) == static_cast<unsigned>(header.columns) &&
                            image.GetDimension(1) == static_cast<unsigned>(header.rows) &&
                            image.GetBufferLength() == pixel_count * format.GetPixelSize();
  if (!as_announced) throw_undecodable(header);
  std::vector<char> bytes(image.GetBufferLength());
  if (!image.GetBuffer(bytes.data())) throw_undecodable(header);
  return rescaled(bytes, format.GetScalarType(), header);
}

}  // namespace isostack
