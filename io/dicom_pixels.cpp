#include "io/dicom_pixels.h"

#include <fmt/format.h>
#include <gdcmImage.h>
#include <gdcmReader.h>

#include <vector>

#include "io/gdcm_setup.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

const gdcm::Tag pixel_data(0x7fe0, 0x0010);

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

void require_sensible_bits(const DicomHeader& header) {
  // GDCM leaves the bytes of 32-bit pixels in the order of the file.
  const bool is_big_endian = header.transfer_syntax.find("Big Endian") != std::string::npos;
  const bool whole_bytes =
      header.bits_allocated == 8 || header.bits_allocated == 16 || (header.bits_allocated == 32 && !is_big_endian);
  if (!whole_bytes || header.bits_stored < 1 || header.bits_stored > header.bits_allocated)
    throw InputError(
        header.name,
        fmt::format("pixels of {} in {} bits are not supported", header.bits_stored, header.bits_allocated),
        "convert the file to 8, 16 or 32 bits");
}

/// The image from the few elements that matter: GDCM's image reader ends the program on others
/// that are empty or inconsistent.
void describe_image(const gdcm::File& file, const DicomHeader& header, gdcm::Image& image) {
  image.SetNumberOfDimensions(2);
  image.SetDimension(0, static_cast<unsigned>(header.columns));
  image.SetDimension(1, static_cast<unsigned>(header.rows));
  const auto bits = static_cast<unsigned short>(header.bits_stored);
  image.SetPixelFormat(gdcm::PixelFormat(1, static_cast<unsigned short>(header.bits_allocated), bits,
                                         static_cast<unsigned short>(bits - 1), header.is_signed ? 1 : 0));
  image.SetPhotometricInterpretation(header.photometric == "MONOCHROME1"
                                         ? gdcm::PhotometricInterpretation::MONOCHROME1
                                         : gdcm::PhotometricInterpretation::MONOCHROME2);
  image.SetTransferSyntax(file.GetHeader().GetDataSetTransferSyntax());
  image.SetDataElement(file.GetDataSet().GetDataElement(pixel_data));
}

}  // namespace

void require_grey_single_frame(const DicomHeader& header) {
  if (header.samples_per_pixel != 1 || header.photometric == "PALETTE COLOR")
    throw InputError(header.name, fmt::format("the image is coloured ({})", header.photometric),
                     "give grey images; colour is not a measurement");
  if (header.frames != 1)
    throw InputError(header.name, fmt::format("the file holds {} frames", header.frames),
                     "multi-frame DICOM is not supported; convert it to one file per slice or to NIfTI");
}

Image<float> read_dicom_pixels(const DicomHeader& header) {
  require_grey_single_frame(header);
  set_up_gdcm();
  require_sensible_bits(header);
  const auto pixel_count = static_cast<std::size_t>(header.rows) * static_cast<std::size_t>(header.columns);
  gdcm::Reader reader;
  reader.SetFileName(header.path.c_str());
  // Whatever follows the pixels need not be sound.
  if (!reader.ReadSelectedTags({pixel_data}) || !reader.GetFile().GetDataSet().FindDataElement(pixel_data))
    throw_undecodable(header);
  const gdcm::ByteValue* plain = reader.GetFile().GetDataSet().GetDataElement(pixel_data).GetByteValue();
  if (plain && plain->GetLength() < pixel_count * static_cast<std::size_t>(header.bits_allocated / 8))
    throw_undecodable(header);  // GDCM would leave the rest of the image undefined
  gdcm::Image image;
  describe_image(reader.GetFile(), header, image);
  // Decompressing may find another sign or depth than the header, never another size.
  if (image.GetBufferLength() < pixel_count) throw_undecodable(header);
  std::vector<char> bytes(image.GetBufferLength());
  if (!image.GetBuffer(bytes.data())) throw_undecodable(header);
  const gdcm::PixelFormat format = image.GetPixelFormat();
  if (bytes.size() != pixel_count * format.GetPixelSize()) throw_undecodable(header);
  return rescaled(bytes, format.GetScalarType(), header);
}

}  // namespace isostack
