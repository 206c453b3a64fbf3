#include "io/dicom/dicom_decoder.h"

#include <gdcmImage.h>
#include <gdcmSequenceOfFragments.h>

#include <string_view>
#include <vector>

#include "io/dicom/dicom_fragments.h"
#include "io/dicom/dicom_reader.h"
#include "io/dicom/stored_pixels.h"

namespace isostack {

namespace {

const gdcm::Tag pixel_data(0x7fe0, 0x0010);

std::vector<std::string_view> views_of(const gdcm::SequenceOfFragments& fragments) {
  std::vector<std::string_view> views;
  for (gdcm::SequenceOfFragments::SizeType i = 0; i < fragments.GetNumberOfFragments(); ++i) {
    const gdcm::ByteValue* value = fragments.GetFragment(i).GetByteValue();
    views.push_back(value ? std::string_view(value->GetPointer(), value->GetLength()) : std::string_view());
  }
  return views;
}

/// The fragments of one frame as the pixel data of an image of its own; empty when there are none.
gdcm::DataElement compressed_frame(const gdcm::DataElement& all, const DicomHeader& header) {
  gdcm::DataElement element(pixel_data);
  const gdcm::SequenceOfFragments* fragments = all.GetSequenceOfFragments();
  if (!fragments) return element;
  const std::vector<std::string_view> views = views_of(*fragments);
  const auto starts = frame_starts(views, static_cast<std::size_t>(header.frames));
  if (starts.empty()) return element;
  const auto frame = static_cast<std::size_t>(header.frame);
  const auto size = codestream_size(views[starts[frame]]);
  if (size && *size != std::pair(header.columns, header.rows)) return element;  // GDCM would make room for either
  const auto one = gdcm::SequenceOfFragments::New();
  for (std::size_t i = starts[frame]; i < starts[frame + 1]; ++i) one->AddFragment(fragments->GetFragment(i));
  element.SetVR(gdcm::VR::OB);
  element.SetValue(*one);
  return element;
}

/// The bytes of one frame of pixels that GDCM has inflated.
gdcm::DataElement plain_frame(const gdcm::DataElement& all, const DicomHeader& header) {
  gdcm::DataElement element(pixel_data);
  const gdcm::ByteValue* bytes = all.GetByteValue();
  const std::size_t frame_bytes = static_cast<std::size_t>(header.rows) * static_cast<std::size_t>(header.columns) *
                                  static_cast<std::size_t>(header.bits_allocated / 8);
  const std::size_t begin = frame_bytes * static_cast<std::size_t>(header.frame);
  if (!bytes || bytes->GetLength() < begin + frame_bytes) return element;
  element.SetVR(header.bits_allocated > 8 ? gdcm::VR::OW : gdcm::VR::OB);
  element.SetByteValue(bytes->GetPointer() + begin, static_cast<std::uint32_t>(frame_bytes));
  return element;
}

/// The image from the few elements that matter: GDCM's image reader ends the program on others
/// that are empty or inconsistent.
void describe_image(const DicomHeader& header, gdcm::Image& image) {
  image.SetNumberOfDimensions(2);
  image.SetDimension(0, static_cast<unsigned>(header.columns));
  image.SetDimension(1, static_cast<unsigned>(header.rows));
  const auto bits = static_cast<unsigned short>(header.bits_stored);
  image.SetPixelFormat(gdcm::PixelFormat(1, static_cast<unsigned short>(header.bits_allocated), bits,
                                         static_cast<unsigned short>(bits - 1), header.is_signed ? 1 : 0));
  image.SetPhotometricInterpretation(header.photometric == "MONOCHROME1"
                                         ? gdcm::PhotometricInterpretation::MONOCHROME1
                                         : gdcm::PhotometricInterpretation::MONOCHROME2);
}

/// What decoding found instead of what the header says: the depth, and that values have a sign.
/// A codestream without a sign holds signed values as their bits.
DicomHeader as_decoded(const DicomHeader& header, const gdcm::PixelFormat& format) {
  DicomHeader decoded = header;
  decoded.bits_allocated = format.GetBitsAllocated();
  decoded.bits_stored = format.GetBitsStored();
  decoded.high_bit = decoded.bits_stored - 1;
  decoded.is_signed = header.is_signed || format.GetPixelRepresentation() == 1;
  return decoded;
}

}  // namespace

struct DicomDecoder::OpenFile {
  explicit OpenFile(const std::filesystem::path& file) : reader(file), path(file) {}

  DicomReader reader;
  std::filesystem::path path;
  bool is_readable = false;
};

DicomDecoder::DicomDecoder() = default;
DicomDecoder::~DicomDecoder() = default;

bool DicomDecoder::decode(const DicomHeader& header, float* pixels) {
  if (!open_ || open_->path != header.path) {
    open_ = std::make_unique<OpenFile>(header.path);
    // Whatever follows the pixels need not be sound.
    open_->is_readable = open_->reader->ReadSelectedTags({pixel_data});
  }
  const gdcm::File& file = open_->reader->GetFile();
  if (!open_->is_readable || !file.GetDataSet().FindDataElement(pixel_data)) return false;
  const gdcm::DataElement& all = file.GetDataSet().GetDataElement(pixel_data);
  const gdcm::DataElement frame = header.is_compressed ? compressed_frame(all, header) : plain_frame(all, header);
  if (frame.IsEmpty()) return false;
  gdcm::Image image;
  describe_image(header, image);
  image.SetTransferSyntax(file.GetHeader().GetDataSetTransferSyntax());
  image.SetDataElement(frame);
  // Decompressing may find another sign or depth than the header, never another size.
  std::vector<char> bytes(image.GetBufferLength());
  if (bytes.empty() || !image.GetBuffer(bytes.data())) return false;
  const DicomHeader decoded = as_decoded(header, image.GetPixelFormat());
  const bool whole_bytes = decoded.bits_allocated == 8 || decoded.bits_allocated == 16 || decoded.bits_allocated == 32;
  const std::size_t pixel_count = static_cast<std::size_t>(header.rows) * static_cast<std::size_t>(header.columns);
  if (!whole_bytes || bytes.size() != pixel_count * static_cast<std::size_t>(decoded.bits_allocated / 8)) return false;
  rescale_stored(bytes.data(), decoded, pixel_count, pixels);
  return true;
}

}  // namespace isostack
