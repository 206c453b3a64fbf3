#include "io/dicom/dicom_pixels.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <fstream>

#include "io/dicom/child_processes.h"
#include "io/dicom/dicom_decoder.h"
#include "io/dicom/gdcm_setup.h"
#include "io/dicom/stored_pixels.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

InputError undecodable(const DicomHeader& header) {
  return {header.name, fmt::format("its pixels cannot be decoded ({})", header.transfer_syntax),
          "the file is cut off, damaged or of an unsupported compression; copy it again or decompress it"};
}

void require_sensible_bits(const DicomHeader& header) {
  const bool whole_bytes = header.bits_allocated == 8 || header.bits_allocated == 16 || header.bits_allocated == 32;
  const bool fit =
      header.bits_stored >= 1 && header.high_bit < header.bits_allocated && header.high_bit + 1 >= header.bits_stored;
  if (!whole_bytes || !fit)
    throw InputError(
        header.name,
        fmt::format("pixels of {} in {} bits are not supported", header.bits_stored, header.bits_allocated),
        "convert the file to 8, 16 or 32 bits");
}

std::size_t pixel_count(const DicomHeader& header) {
  return static_cast<std::size_t>(header.rows) * static_cast<std::size_t>(header.columns);
}

void turn_round(char* bytes, std::size_t count, std::size_t group) {
  for (std::size_t i = 0; i + group <= count; i += group) std::reverse(bytes + i, bytes + i + group);
}

/// Uncompressed pixels, straight from their place in the file; empty when they are not all there.
Image<float> read_plain(const DicomHeader& header) {
  const auto pixel_bytes = static_cast<std::size_t>(header.bits_allocated / 8);
  const std::size_t frame_bytes = pixel_count(header) * pixel_bytes;
  const std::uintmax_t begin = frame_bytes * static_cast<std::uintmax_t>(header.frame);
  if (begin + frame_bytes > header.pixel_bytes) return {};
  std::ifstream stream(header.path, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(header.pixel_offset + begin));
  Image<float> pixels(header.rows, header.columns);
  constexpr std::size_t piece_bytes = 1 << 16;  // stays in the cache
  std::vector<char> bytes(std::min(frame_bytes, piece_bytes));
  for (std::size_t done = 0; done < frame_bytes; done += bytes.size()) {
    const std::size_t count = std::min(bytes.size(), frame_bytes - done);
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(count))) return {};
    if (header.swapped_bytes > 0) turn_round(bytes.data(), count, static_cast<std::size_t>(header.swapped_bytes));
    rescale_stored(bytes.data(), header, count / pixel_bytes, pixels.data() + done / pixel_bytes);
  }
  return pixels;
}

/// Those pictures that GDCM must decode; the images of those it cannot stay empty.
void decode_with_gdcm(const std::vector<DicomHeader>& headers, const std::vector<std::size_t>& which,
                      std::vector<Image<float>>& images) {
  set_up_gdcm();
  std::vector<std::size_t> result_bytes;
  for (const std::size_t i : which) result_bytes.push_back(pixel_count(headers[i]) * sizeof(float));
  DicomDecoder decoder;  // each child has its copy
  const auto results = run_in_children(result_bytes, [&](std::size_t task, char* result) {
    return decoder.decode(headers[which[task]], reinterpret_cast<float*>(result));
  });
  for (std::size_t task = 0; task < which.size(); ++task) {
    const DicomHeader& header = headers[which[task]];
    if (results[task].empty()) continue;
    const auto* values = reinterpret_cast<const float*>(results[task].data());
    images[which[task]] = Eigen::Map<const Image<float>>(values, header.rows, header.columns);
  }
}

/// The end of a batch that begins there: as many pictures as take some 64 MB, for the sake of progress and memory.
std::size_t batch_end(const std::vector<DicomHeader>& headers, std::size_t begin) {
  constexpr std::size_t most_bytes = std::size_t{1} << 26;
  std::size_t bytes = 0, end = begin;
  while (end < headers.size() && (end == begin || bytes < most_bytes))
    bytes += pixel_count(headers[end++]) * sizeof(float);
  return end;
}

}  // namespace

void require_grey(const DicomHeader& header) {
  if (header.samples_per_pixel != 1 || header.photometric == "PALETTE COLOR")
    throw InputError(header.name, fmt::format("the image is coloured ({})", header.photometric),
                     "give grey images; colour is not a measurement");
  require_sensible_bits(header);
}

std::vector<Image<float>> read_dicom_pixels(const std::vector<DicomHeader>& headers, const Progress& progress) {
  DicomPictures pictures = read_dicom_pictures(headers, progress);
  for (const std::optional<InputError>& failure : pictures.failures)
    if (failure) throw InputError(*failure);
  return std::move(pictures.images);
}

DicomPictures read_dicom_pictures(const std::vector<DicomHeader>& headers, const Progress& progress) {
  for (const DicomHeader& header : headers) require_grey(header);
  DicomPictures pictures;
  std::vector<Image<float>>& images = pictures.images;
  images.resize(headers.size());
  pictures.failures.resize(headers.size());
  for (std::size_t begin = 0, end = 0; begin < headers.size(); begin = end) {
    progress.report("pixels", static_cast<double>(begin) / static_cast<double>(headers.size()));
    end = batch_end(headers, begin);
    std::vector<std::size_t> plain, encoded;
    for (std::size_t i = begin; i < end; ++i) (headers[i].pixel_offset != 0 ? plain : encoded).push_back(i);
    tbb::parallel_for(std::size_t{0}, plain.size(),
                      [&](std::size_t i) { images[plain[i]] = read_plain(headers[plain[i]]); });
    if (!encoded.empty()) decode_with_gdcm(headers, encoded, images);
  }
  progress.report("pixels", 1);
  for (std::size_t i = 0; i < headers.size(); ++i)
    if (images[i].size() == 0) pictures.failures[i] = undecodable(headers[i]);
  return pictures;
}

}  // namespace isostack
