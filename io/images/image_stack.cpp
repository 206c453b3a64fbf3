#include "io/images/image_stack.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "io/file_listing.h"
#include "io/formats.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// Full scale of the stored integers: OpenImageIO maps them to [0, 1] when read as floats.
float full_scale(const OIIO::TypeDesc& type) {
  if (type == OIIO::TypeDesc::UINT8) return 255;
  if (type == OIIO::TypeDesc::UINT16) return 65535;
  return 1;
}

[[noreturn]] void throw_unreadable(const std::filesystem::path& path) {
  OIIO::geterror();  // take the library's pending text, which it would print at exit
  throw InputError(path.string(), "the image cannot be decoded", "it is truncated or damaged; save it again");
}

void require_grey(const OIIO::ImageSpec& spec, const std::filesystem::path& path) {
  const bool has_alpha = spec.alpha_channel >= 0;
  if (spec.nchannels - (has_alpha ? 1 : 0) != 1)
    throw InputError(path.string(), fmt::format("the image has {} channels", spec.nchannels),
                     "convert it to greyscale; colour is not a measurement");
  const OIIO::TypeDesc type = spec.format;
  if (type != OIIO::TypeDesc::UINT8 && type != OIIO::TypeDesc::UINT16 && type != OIIO::TypeDesc::FLOAT &&
      type != OIIO::TypeDesc::HALF)
    throw InputError(path.string(), fmt::format("pixels of type {} are not supported", type.c_str()),
                     "save it with 8 or 16 bits or as float");
}

Image<float> read_image(const std::filesystem::path& path) {
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) throw_unreadable(path);
  const OIIO::ImageSpec& spec = input->spec();
  require_grey(spec, path);
  Image<float> pixels(spec.height, spec.width);
  const bool read = input->read_image(0, 0, 0, 1, OIIO::TypeDesc::FLOAT, pixels.data());
  if (!read) {
    input->geterror();
    throw_unreadable(path);
  }
  const float scale = full_scale(spec.format);
  // Whole numbers come back exactly only after rounding.
  if (scale > 1) pixels = (pixels * scale).round();
  return pixels;
}

void require_equal_sizes(const std::vector<Slice>& slices) {
  const Image<float>& first = slices.front().pixels;
  for (const Slice& slice : slices)
    if (slice.pixels.rows() != first.rows() || slice.pixels.cols() != first.cols())
      throw InputError(slice.name,
                       fmt::format("the image has {} x {} pixels, but {} has {} x {}", slice.pixels.cols(),
                                   slice.pixels.rows(), slices.front().name, first.cols(), first.rows()),
                       "give images of one size");
}

Eigen::Vector3d required_spacing(const std::filesystem::path& path, const ReadOptions& options) {
  if (!options.spacing_mm)
    throw InputError(path.string(), "images do not say how large their pixels are",
                     "give --spacing COLUMN,ROW,SLICE in mm");
  if (!options.spacing_mm->allFinite() || !(options.spacing_mm->minCoeff() > 0))
    throw InputError("--spacing", "every distance must be a positive number of mm", "give three, such as 0.5,0.5,2");
  return *options.spacing_mm;
}

}  // namespace

std::vector<std::filesystem::path> images_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> images;
  for (const auto& path : files_in(folder, Depth::kThisFolder)) {
    const Format* format = find_format(path, &Format::read_slices);
    if (format && format->read_slices == read_image_stack) images.push_back(path);
  }
  return images;
}

ImageInfo image_info(const std::filesystem::path& path) {
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) throw_unreadable(path);
  const OIIO::ImageSpec& spec = input->spec();
  return {spec.width, spec.height, input->format_name(), spec.format.c_str()};
}

SliceStack read_image_stack(const std::filesystem::path& path, const ReadOptions& options, const Progress& progress) {
  const Eigen::Vector3d spacing_mm = required_spacing(path, options);
  const auto files = std::filesystem::is_directory(path) ? images_in(path) : std::vector{path};
  SliceStack stack;
  stack.name = std::filesystem::is_directory(path) ? "images" : path.filename().string();
  stack.slices.resize(files.size());
  progress.report("images", 0);
  tbb::parallel_for(std::size_t{0}, files.size(), [&](std::size_t k) {
    Slice& slice = stack.slices[k];
    slice.name = files[k].filename().string();
    slice.pose.origin_mm.z() = static_cast<double>(k) * spacing_mm.z();
    slice.pose.spacing_mm = spacing_mm.head<2>();
    slice.pixels = read_image(files[k]);
  });
  progress.report("images", 1);
  require_equal_sizes(stack.slices);
  return stack;
}

}  // namespace isostack
