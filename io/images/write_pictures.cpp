#include "io/images/write_pictures.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <memory>

#include "io/atomic_file.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

[[noreturn]] void throw_no_pixels(const std::filesystem::path& path) {
  throw InputError(path.string(), "a picture without pixels cannot be written", "draw it with a size above 0");
}

void require_pixels(const Picture& picture, const std::filesystem::path& path) {
  const auto bytes = std::size_t{3} * static_cast<std::size_t>(std::max(picture.width_pixels, 0)) *
                     static_cast<std::size_t>(std::max(picture.height_pixels, 0));
  if (bytes == 0 || picture.rgb.size() != bytes) throw_no_pixels(path);
}

/// The library's own words would not help; its pending text is taken, for it prints that at exit.
[[noreturn]] void throw_unwritable(const std::filesystem::path& path) {
  OIIO::geterror();
  throw InputError(path.string(), "the picture cannot be written",
                   "choose a folder that is writable and has free space");
}

std::unique_ptr<OIIO::ImageOutput> output_for(const std::filesystem::path& path) {
  auto output = OIIO::ImageOutput::create(path.string());
  if (!output) throw_unwritable(path);
  return output;
}

void write_bytes(const OIIO::ImageSpec& spec, const std::uint8_t* bytes, const std::filesystem::path& path) {
  AtomicFile file(path);
  const auto output = output_for(file.temporary());
  if (!output->open(file.temporary().string(), spec) || !output->write_image(OIIO::TypeDesc::UINT8, bytes) ||
      !output->close()) {
    output->geterror();
    throw_unwritable(path);
  }
  file.commit();
}

OIIO::ImageSpec spec_of(const Picture& picture) {
  return {picture.width_pixels, picture.height_pixels, 3, OIIO::TypeDesc::UINT8};
}

}  // namespace

void write_png(const Picture& picture, const std::filesystem::path& path) {
  require_pixels(picture, path);
  write_bytes(spec_of(picture), picture.rgb.data(), path);
}

void write_png(const Image<std::uint8_t>& pixels, const std::filesystem::path& path) {
  if (pixels.size() == 0) throw_no_pixels(path);
  write_bytes({static_cast<int>(pixels.cols()), static_cast<int>(pixels.rows()), 1, OIIO::TypeDesc::UINT8},
              pixels.data(), path);
}

void write_gif(const std::vector<Picture>& pictures, const std::filesystem::path& path, const GifOptions& options) {
  if (pictures.empty())
    throw InputError(path.string(), "an animation needs at least one picture", "ask for more frames");
  for (const Picture& picture : pictures) {
    require_pixels(picture, path);
    if (picture.width_pixels != pictures.front().width_pixels ||
        picture.height_pixels != pictures.front().height_pixels)
      throw InputError(path.string(), "the pictures of an animation are not of one size", "draw all in one frame");
  }
  OIIO::ImageSpec spec = spec_of(pictures.front());
  spec.attribute("FramesPerSecond", static_cast<float>(options.frames_per_second));
  spec.attribute("gif:LoopCount", 0);  // for ever
  AtomicFile file(path);
  const std::string name = file.temporary().string();
  const auto output = output_for(name);
  bool written = true;
  for (std::size_t i = 0; i < pictures.size() && written; ++i)
    written = output->open(name, spec, i == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendSubimage) &&
              output->write_image(OIIO::TypeDesc::UINT8, pictures[i].rgb.data());
  if (!output->close() || !written) {
    output->geterror();
    throw_unwritable(path);
  }
  file.commit();
}

}  // namespace isostack
